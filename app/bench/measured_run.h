// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// What some steps of a simulation cost, and what they did.
struct StepCost {
    double seconds = 0;    ///< of processor time, of all threads
    double simulated = 0;  ///< s
    std::int64_t steps = 0, iterations = 0, factorizations = 0, analyses = 0;
    std::int64_t stages = 0;    ///< of breaking
    std::int64_t halvings = 0;  ///< of steps that could not be solved
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

}  // namespace sherd
