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

/// Cost of several steps of a simulation, and numbers of their operations.
struct StepCost {
    double seconds = 0;    ///< s, processor time of all threads
    double simulated = 0;  ///< s, simulated time
    std::int64_t steps = 0, iterations = 0, factorizations = 0, analyses = 0;
    std::int64_t stages = 0;    ///< stages of breaking
    std::int64_t halvings = 0;  ///< halvings of steps that could not be solved
    std::int64_t contacts = 0;  ///< vertices in contact with obstacles or bodies, a sum over the steps

    StepCost& operator+=(const StepCost& more);
    double rate() const { return simulated / seconds; }  ///< simulated time over processor time
};

/// Positions (m) and velocities (m/s) of a shell's vertices, [3, V].
struct ShellMotion {
    Positions position, velocity;
};

/// A simulation whose steps are measured.
class MeasuredRun {
  public:
    /// Begins in the initial state of the scene or, if `start` is given, with these positions and velocities
    /// of the scene's vertices.
    explicit MeasuredRun(const Scene& scene, const std::optional<ShellMotion>& start = {});

    /// Makes steps until `time` (s), and returns their cost. Begins no step after `most_seconds` of processor
    /// time. The first step that cannot be solved ends the run: see failure().
    StepCost advance_to(double time, double most_seconds = std::numeric_limits<double>::infinity());
    const Shell& shell() const { return simulation->shell().mechanics(); }
    ShellMotion motion() const { return {shell().position, shell().velocity}; }
    double time() const { return simulation->time(); }
    bool has_reached(double end) const { return time() >= end * (1 - 1e-9); }
    const std::string& failure() const { return why; }  ///< why a step cannot be solved; empty: none failed

  private:
    std::unique_ptr<Simulation> simulation;
    std::string why;
};

/// Options of a race, in which simulations take turns after each lap, a stretch of simulated time.
struct RaceOptions {
    double step = 1e-4;  ///< s, simulated time of a lap
    /// Number of laps before the measured ones. They contain the analysis of patterns, first factorizations
    /// and the adaptation to another size of steps.
    int settling = 2;
    int laps = 10;  ///< number of measured laps
    /// A simulation leaves the race when it has taken this many times the first simulation's processor time.
    double allowance = 6;
};

/// Result of one simulation in a race.
struct RaceResult {
    std::vector<StepCost> laps;           ///< cost of each measured lap
    ShellMotion end;                      ///< motion at the end of the race
    std::size_t vertices = 0, faces = 0;  ///< numbers of vertices and faces at the start
    std::int64_t halvings = 0;            ///< halvings of steps in all laps, settling laps included
    double memory = 0;                    ///< bytes, largest memory of the simulation in its settling laps
    bool is_out = false;  ///< took too long: there are fewer laps, and the last lap is incomplete
    std::string failure;  ///< why a step could not be solved; empty: none failed

    bool has_finished() const { return !is_out && failure.empty(); }
    StepCost cost() const;  ///< cost of all laps
};

/// Simulates the scenes, which differ only in their solvers, in laps of equal simulated time. The simulations
/// make each lap in turn, so that other load on the machine affects all alike. The first simulation never
/// leaves the race. start: see MeasuredRun. Returns a result for each scene.
std::vector<RaceResult> race(const std::vector<Scene>& scenes, const RaceOptions& options,
                             const std::optional<ShellMotion>& start = {});

}  // namespace sherd
