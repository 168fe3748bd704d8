// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sherd {

/// Limits on what run_isolated() may use.
struct IsolationLimits {
    std::uint64_t memory = std::uint64_t(1) << 30;  ///< bytes, in addition to what the process has already
    std::uint64_t seconds = 60;                     ///< s, processor time
};

/// Tries `work` in a forked copy of this process, which then exits. A crash or an invalid write affects only
/// the copy. If `work` succeeds there, the caller can safely repeat it in this process. Throws Error with the
/// message of an exception that `work` throws; with the message `crash` if the copy crashes or exceeds a
/// limit; or with Fault::run if the copy cannot be started. Returns without trying `work` while other threads
/// use TBB, since a forked process has the calling thread only.
void run_isolated(const std::function<void()>& work, const IsolationLimits& limits, const std::string& crash);

}  // namespace sherd
