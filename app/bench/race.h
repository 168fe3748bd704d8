// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/bench/measured_run.h"

namespace sherd {

struct RaceOptions {
    double step = 1e-4;    ///< s, of a lap
    int settling = 2;      ///< laps that are not measured: patterns, first factors, the change of the step
    int laps = 10;         ///< that are
    double allowance = 6;  ///< times the first one's processor time, with which one is out of the race
};

/// How one did in a race.
struct RaceResult {
    std::vector<StepCost> laps;
    ShellMotion end;
    std::size_t vertices = 0, faces = 0;  ///< at the start
    std::int64_t halvings = 0;            ///< of all steps, those before the laps too
    double memory = 0;                    ///< bytes, the most that it took until its laps were measured
    bool is_out = false;  ///< took too long: its laps are fewer, and the last one is a part of one
    std::string failure;  ///< why it could not go on; empty: it could

    bool has_finished() const { return !is_out && failure.empty(); }
    StepCost cost() const;  ///< of all laps
};

/// Lets simulations of these scenes, which differ in how they are solved, make the same laps of simulated
/// time in turn, so that what else the machine does meets all of them alike. The first one is never out.
std::vector<RaceResult> race(const std::vector<Scene>& scenes, const RaceOptions& options,
                             const std::optional<ShellMotion>& start = {});

}  // namespace sherd
