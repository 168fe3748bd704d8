// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time_step.h"
#include "fracture/breakable_sheet.h"
#include "fracture/events.h"
#include "fracture/snapshot.h"
#include "fracture/step_report.h"
#include "meshops/components.h"

namespace sherd {

struct SimulationOptions {
    double step = 1e-4;             ///< s
    Vector3d gravity{0, 0, -9.81};  ///< m/s^2
    std::vector<Plane> planes;      ///< obstacles
    BendingOptions bending;         ///< energy and Jacobian of the hinges
    int max_iterations = 50;        ///< of Newton's method, between two stages
    double tolerance = 1e-6;        ///< largest last Newton correction, in mean edge lengths
    int max_stages = 100;           ///< of breaking in one step
    double crack_tip_factor = 0.7;  ///< times the strength of a hinge that continues a crack
};

/// Sheets that move, bend and break.
class Simulation {
  public:
    /// inputs: at least one.
    Simulation(const std::vector<SheetInput>& inputs, const SimulationOptions& options);
    Simulation(const Simulation&) = delete;  // the time step refers to the sheet

    /// Advances by one time step: solve, judge the hinges, break the most overloaded, and solve the same step
    /// again until none is over its strength.
    StepReport step();

    Snapshot snapshot() const;
    const BreakableSheet& sheet() const { return breakable; }
    /// The crack events since the last call.
    CrackEvents take_events();
    double time() const { return static_cast<double>(steps) * options.step; }  ///< s

  private:
    NewtonResult solve_stage(StepReport& report, int max_iterations);
    void break_edges(std::span<const Edge> edges, const VectorXd& strains, Index stage);
    void record_failures(std::span<const Edge> edges, const VectorXd& strains, Index stage);
    void record_change(const CrackMesh::Change& change);
    void finish(StepReport& report);

    SimulationOptions options;
    BreakableSheet breakable;
    TimeStep time_step;
    Components fragments;
    CrackEvents events;
    std::int64_t steps = 0;
};

}  // namespace sherd
