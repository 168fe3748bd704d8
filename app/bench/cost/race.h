// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Cost of some steps of a simulation, and their work.
struct StepCost {
    double seconds = 0;    ///< processor time of all threads
    double simulated = 0;  ///< s
    std::int64_t steps = 0, iterations = 0, factorizations = 0, analyses = 0;
    std::int64_t stages = 0;    ///< stages of breaking
    std::int64_t halvings = 0;  ///< halvings of steps that could not be solved
    std::int64_t contacts = 0;  ///< vertices in contact with obstacles or bodies, a sum over the steps

    StepCost& operator+=(const StepCost& more);
    double rate() const { return simulated / seconds; }  ///< s simulated in a second
};

/// Where a shell is, m, and how fast, m/s: [3, V].
struct ShellMotion {
    Positions position, velocity;
};

/// A simulation whose steps are measured.
class MeasuredRun {
  public:
    /// Begins where the scene does, or at `start`, with vertices as the scene's are.
    explicit MeasuredRun(const Scene& scene, const std::optional<ShellMotion>& start = {});

    /// Steps until this time, and returns what that cost. The first step that cannot be solved ends the run;
    /// after `most_seconds` of processor time no step is begun.
    StepCost advance_to(double time, double most_seconds = std::numeric_limits<double>::infinity());
    const Shell& shell() const { return simulation->shell().mechanics(); }
    ShellMotion motion() const { return {shell().position, shell().velocity}; }
    double time() const { return simulation->time(); }
    bool has_reached(double end) const { return time() >= end * (1 - 1e-9); }
    const std::string& failure() const { return why; }  ///< empty: there was none

  private:
    std::unique_ptr<Simulation> simulation;
    std::string why;
};

struct RaceOptions {
    double step = 1e-4;    ///< s, of a lap
    int settling = 2;      ///< laps that are not measured: patterns, first factors, the change of the step
    int laps = 10;         ///< measured laps
    double allowance = 6;  ///< times the first one's processor time, with which one is out of the race
};

/// How one did in a race.
struct RaceResult {
    std::vector<StepCost> laps;
    ShellMotion end;
    std::size_t vertices = 0, faces = 0;  ///< at the start
    std::int64_t halvings = 0;            ///< in all steps, those before the laps too
    double memory = 0;                    ///< bytes, the most that it took until its laps were measured
    bool is_out = false;  ///< took too long: its laps are fewer, and the last one is a part of one
    std::string failure;  ///< why it could not go on; empty: it could

    bool has_finished() const { return !is_out && failure.empty(); }
    StepCost cost() const;  ///< cost of all laps
};

/// Lets simulations of these scenes, which differ in how they are solved, make the same laps of simulated
/// time in turn, so that what else the machine does meets all of them alike. The first one is never out.
std::vector<RaceResult> race(const std::vector<Scene>& scenes, const RaceOptions& options,
                             const std::optional<ShellMotion>& start = {});

}  // namespace sherd
