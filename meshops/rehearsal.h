// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace sherd {

/// What a rehearsal may use.
struct RehearsalLimits {
    std::uint64_t memory = std::uint64_t(1) << 30;  ///< bytes, beyond what the process has already
    std::uint64_t seconds = 60;                     ///< of processor time
};

/// Does `work` in a copy of this process, which ends with it: what crashes there, or writes where it must
/// not, does so in the copy alone, and nothing else remains of it. Afterwards the same can be done here.
/// Throws an Error of what the exception says that `work` throws there; of `crash` if it ends otherwise or
/// exceeds a limit; or with Fault::run if there can be no further process. Does nothing while other threads
/// use TBB, as a copy has no thread but this one.
void rehearse(const std::function<void()>& work, const RehearsalLimits& limits, const std::string& crash);

}  // namespace sherd
