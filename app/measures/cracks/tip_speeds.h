// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Growth of cracks in a step, and the speeds of their tips.
struct TipStep {
    double time = 0;       ///< s, end of the step
    double step_size = 0;  ///< s
    double length = 0;     ///< m, length at rest of the edges that failed in the step
    std::size_t tips = 0;  ///< number of tips that advanced
    double speed = 0;      ///< m/s, mean over the tips
    double fastest = 0;    ///< m/s, speed of the fastest tip
};

/// Steps in which crack tips advanced. If the recording has records of crack tips, which cracks by toughness
/// have, the tips are the recorded ones with a positive speed. Without any records, each connected set of
/// edges that failed in a step has a tip at each of its ends that lies neither on an earlier crack nor on the
/// rim, or a single tip if there is no such end; each tip advanced by an equal share of the set's length in
/// the step.
struct TipSpeeds {
    std::vector<TipStep> steps;
    bool recorded = false;  ///< whether the tips are those of records

    double mean() const;      ///< m/s, mean over tips, weighted by step durations; 0 without steps
    TipStep fastest() const;  ///< the first step with the fastest tip; all zero without steps
};

/// Returns the speeds of the tips of a run. frame: last frame of the run. on_rim: [R] CrackGraph::on_rim for
/// its vertices at rest.
TipSpeeds tip_speeds(const CrackEvents& events, const std::vector<StepReport>& steps, const Snapshot& frame,
                     const std::vector<char>& on_rim);

}  // namespace sherd
