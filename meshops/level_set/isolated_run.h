// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sherd {

/// Limits on the resources of a rehearsal.
struct IsolationLimits {
    std::uint64_t memory = std::uint64_t(1) << 30;  ///< bytes, beyond what the process has already
    std::uint64_t seconds = 60;                     ///< processor time
};

/// Runs `work` in a forked copy of this process, which then exits. A crash or an invalid write happens in the
/// copy only, and nothing else remains of it; without one, the caller can safely repeat `work` in this
/// process. Throws Error with the message of an exception that `work` throws there; with the message `crash`
/// if the copy ends otherwise or exceeds a limit; or with Fault::run if no process can be started. Does
/// nothing while other threads use TBB, since a forked process has this thread only.
void run_isolated(const std::function<void()>& work, const IsolationLimits& limits, const std::string& crash);

}  // namespace sherd
