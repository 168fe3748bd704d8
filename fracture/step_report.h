// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/energy_balance.h"
#include "core/state_visitor.h"
#include "fracture/gauge.h"
#include "fracture/step_pace.h"
#include "fracture/yielding.h"

namespace sherd {

/// What one time step did, and the state at its end. The balance is since the start of the run.
struct StepReport : EnergyBalance {
    std::int64_t step = 0;  ///< number of the step, from 1
    double time = 0;        ///< s, at its end
    double step_size = 0;   ///< s
    double load = 1;  ///< factor of all loads; in statics its times are load factors, or lengths of path

    double kinetic = 0;                            ///< J
    double bending = 0;                            ///< J
    double membrane = 0;                           ///< J
    double gravity = 0;                            ///< J, potential energy, zero at the origin
    double contact = 0;                            ///< J, elastic energy of the contacts
    double residual = 0;                           ///< J, of the residual stress of tempered sheets
    Vector3d linear_momentum = Vector3d::Zero();   ///< kg m/s
    Vector3d angular_momentum = Vector3d::Zero();  ///< kg m^2/s, about the origin

    /// Iterations over all stages, and attempts at longer steps; in explicit steps substeps.
    Index newton_iterations = 0;
    Index halvings = 0;  ///< halvings of this step because longer ones could not be solved
    Index stages = 0;    ///< stages of breaking
    bool stage_cap_reached = false;
    bool is_explicit = false;         ///< whether it was made of substeps
    Urgency urgency = Urgency::none;  ///< why steps of the other scheme begin with it
    Index contacts = 0;               ///< number of vertices in contact with obstacles or bodies
    double obstacle_overlap = 0;      ///< m, largest overlap of a sheet with an obstacle or a body
    double lip_overlap = 0;           ///< m, largest overlap of lips of cracks that have not moved apart yet
    Index exempt_pairs = 0;           ///< pairs of vertices whose faces overlap since the start
    Index fragments = 0;

    std::vector<Reaction> reactions;   ///< of the supports, then of the obstacles
    std::vector<GaugeReading> gauges;  ///< of each gauge

    // These are the largest values over the unbroken hinges, before anything broke in this step: see
    // HingeMeasures.
    double peak_strain = 0;          ///< 1/m, surface strain over half the thickness
    double peak_stress = 0;          ///< Pa, surface stress
    double peak_bending_strain = 0;  ///< 1/m, the paper's measure
    double peak_overload = 0;        ///< measure over strength; 0 where nothing can break
    double peak_yield = 0;  ///< of all faces, von Mises stress over yield stress; 0 where nothing yields
    FacePlace yielding;     ///< where that is
    FacePlace fastest;      ///< what asks for short substeps: Stepper::fastest_triangle()

    void visit_state(StateVisitor& visit);
};

/// Raises the peaks of `peaks` to those of `step`, if they are larger there.
inline void raise_peaks(StepReport& peaks, const StepReport& step) {
    for (double StepReport::*peak : {&StepReport::peak_strain, &StepReport::peak_stress,
                                     &StepReport::peak_bending_strain, &StepReport::peak_overload})
        peaks.*peak = std::max(peaks.*peak, step.*peak);
    if (step.peak_yield > peaks.peak_yield) {
        peaks.peak_yield = step.peak_yield;
        peaks.yielding = step.yielding;
    }
}

}  // namespace sherd
