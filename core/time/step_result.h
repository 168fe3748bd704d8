// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace sherd {

/// Outcome of a part of a step.
enum class Outcome : std::uint8_t {
    done,
    too_long,  ///< vertices, obstacles or bodies cannot get to their places at its end
    unsolved,  ///< no minimum has been found
    passage,   ///< surfaces pass through each other in a step to the minimum that has been found
    failed,    ///< the scheme cannot continue from the beginning of the step, however short the step is
};

/// Result of a part of a step: its beginning, or a solution of it.
struct StepResult {
    Outcome outcome = Outcome::done;
    std::string why = {};  ///< message for users where it has failed, and where there is no definite matrix
    int iterations = 0;    ///< number of substeps in explicit steps
    bool limited = false;  ///< whether it is unsolved because of the limit on iterations

    explicit operator bool() const { return outcome == Outcome::done; }
};

}  // namespace sherd
