// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// How far cracks went in a step, and how fast.
struct TipStep {
    double time = 0;       ///< s, end of the step
    double step_size = 0;  ///< s
    double length = 0;     ///< m, of the edges that failed in it, at rest
    std::size_t tips = 0;
    double speed = 0;    ///< m/s, mean of the tips
    double fastest = 0;  ///< m/s
};

/// Steps in which a tip went on. Cracks by toughness have records of their tips: these that have a speed
/// count. Without any records, what failed in a step and hangs together has grown at its ends that lie
/// neither on an earlier crack nor on the rim, or at one end, if all do: each of these tips has its share of
/// the length over the step.
struct TipSpeeds {
    std::vector<TipStep> steps;
    bool recorded = false;  ///< whether the tips are those of records

    double mean() const;      ///< m/s, over tips and the time for which each went on; 0 without steps
    TipStep fastest() const;  ///< the step with the fastest tip, the first of several; zero without steps
};

/// frame: the last one. on_rim: [R] of its vertices at rest.
TipSpeeds tip_speeds(const CrackEvents& events, const std::vector<StepReport>& steps, const Snapshot& frame,
                     const std::vector<char>& on_rim);

}  // namespace sherd
