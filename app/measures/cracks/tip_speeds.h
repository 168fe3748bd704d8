// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Growth of cracks in a step, and its speed.
struct TipStep {
    double time = 0;       ///< s, end of the step
    double step_size = 0;  ///< s
    double length = 0;     ///< m, of the edges that failed in the step, at rest
    std::size_t tips = 0;
    double speed = 0;    ///< m/s, mean of the tips
    double fastest = 0;  ///< m/s, largest of the tips
};

/// Steps in which a tip advanced. Cracks by toughness have records of their tips, of which those with a speed
/// count. Without any records, each connected set of edges that failed in a step has a tip at each of its
/// ends that lies neither on an earlier crack nor on the rim, or a single tip if there is no such end; each
/// tip advanced by an equal share of the set's length in the step.
struct TipSpeeds {
    std::vector<TipStep> steps;
    bool recorded = false;  ///< whether the tips are recorded

    double mean() const;      ///< m/s, mean over tips and the duration of their steps; 0 without steps
    TipStep fastest() const;  ///< the step with the fastest tip, the first of several; zero without steps
};

/// frame: the last one. on_rim: [R] for its vertices at rest.
TipSpeeds tip_speeds(const CrackEvents& events, const std::vector<StepReport>& steps, const Snapshot& frame,
                     const std::vector<char>& on_rim);

}  // namespace sherd
