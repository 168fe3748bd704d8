// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/energy_balance.h"
#include "core/state_visitor.h"
#include "fracture/record/gauge.h"
#include "fracture/record/yielding.h"
#include "fracture/step/step_pace.h"

namespace sherd {

/// Report of one time step, with the state at its end. The energy balance covers the time since the start of
/// the run.
struct StepReport : EnergyBalance {
    std::int64_t step = 0;  ///< number of the step, from 1
    /// s, end of the step; in statics a load factor, or the length of the equilibrium path.
    double time = 0;
    double step_size = 0;  ///< length of the step, in the same unit
    double load = 1;       ///< factor of all loads at the end of the step

    double kinetic = 0;                            ///< J
    double bending = 0;                            ///< J
    double membrane = 0;                           ///< J
    double gravity = 0;                            ///< J, potential energy of gravity, zero at the origin
    double contact = 0;                            ///< J, elastic energy of the contacts
    double residual = 0;                           ///< J, stored by the residual stress of tempered sheets
    Vector3d linear_momentum = Vector3d::Zero();   ///< kg m/s
    Vector3d angular_momentum = Vector3d::Zero();  ///< kg m^2/s, about the origin

    /// Number of iterations in all stages and in failed attempts at the step; in explicit steps, number of
    /// substeps.
    Index newton_iterations = 0;
    Index halvings = 0;  ///< number of halvings of this step because longer steps could not be solved
    Index stages = 0;    ///< number of stages of breaking
    bool stage_cap_reached = false;
    bool is_explicit = false;         ///< whether the step consists of explicit substeps
    Urgency urgency = Urgency::none;  ///< reason for which the scheme changes with this step
    Index contacts = 0;               ///< number of vertices in contact with obstacles or bodies
    double obstacle_overlap = 0;      ///< m, largest overlap of a sheet with an obstacle or a body
    double crack_face_overlap = 0;    ///< m, largest overlap of crack faces that have not separated yet
    Index exempt_pairs = 0;           ///< vertex pairs of faces that overlap since the start: StartExemptions
    Index fragments = 0;

    std::vector<Reaction> reactions;   ///< reactions of supports, then of obstacles
    std::vector<GaugeReading> gauges;  ///< [gauges]

    // Largest values over all hinges that were intact before any failed in this step: see HingeMeasures.
    double peak_strain = 0;          ///< 1/m, surface strain over half the thickness
    double peak_stress = 0;          ///< Pa, surface stress
    double peak_bending_strain = 0;  ///< 1/m, the paper's measure
    double peak_overload = 0;        ///< measure over strength; 0 where nothing can break
    double peak_yield = 0;  ///< von Mises stress over yield stress, of all faces; 0 where nothing yields
    FacePlace yielding;     ///< place of peak_yield
    FacePlace fastest;      ///< face that limits the substeps: Stepper::fastest_triangle()

    void visit_state(StateVisitor& visit);
};

/// Raises each peak in `peaks` to the peak in `step`, if that is larger.
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
