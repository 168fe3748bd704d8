// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace sherd {

/// Outcome of Stepper::begin() or Stepper::solve().
enum class Outcome : std::uint8_t {
    done,
    too_long,  ///< prescribed places at the step's end cannot be reached
    unsolved,  ///< no minimum has been found
    passage,   ///< surfaces pass through each other on the straight path to the minimum
    failed,    ///< the scheme cannot continue from the beginning of the step, however short the step is
};

/// Result of Stepper::begin() or Stepper::solve().
struct StepResult {
    Outcome outcome = Outcome::done;
    std::string why = {};  ///< message for users if the step has failed, or no matrix was definite
    int iterations = 0;    ///< number of iterations; in explicit steps, of substeps
    bool limited = false;  ///< whether the step is unsolved because of the limit on iterations

    explicit operator bool() const { return outcome == Outcome::done; }
};

}  // namespace sherd
