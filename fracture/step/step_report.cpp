// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/step_report.h"

namespace sherd {

void StepReport::visit_state(StateVisitor& visit) {
    static_assert(
        has_only<StepReport, EnergyBalance, decltype(step), decltype(time), decltype(step_size),
                 decltype(load), decltype(kinetic), decltype(bending), decltype(membrane), decltype(gravity),
                 decltype(contact), decltype(residual), decltype(linear_momentum), decltype(angular_momentum),
                 decltype(newton_iterations), decltype(halvings), decltype(stages),
                 decltype(stage_cap_reached), decltype(is_explicit), decltype(urgency), decltype(contacts),
                 decltype(obstacle_overlap), decltype(crack_face_overlap), decltype(exempt_pairs),
                 decltype(fragments), decltype(reactions), decltype(gauges), decltype(peak_strain),
                 decltype(peak_stress), decltype(peak_bending_strain), decltype(peak_overload),
                 decltype(peak_yield), decltype(yielding), decltype(fastest)>());
    visit(static_cast<EnergyBalance&>(*this), step, time, step_size, load, kinetic, bending, membrane,
          gravity, contact, residual, linear_momentum, angular_momentum, newton_iterations, halvings, stages,
          stage_cap_reached, is_explicit, urgency, contacts, obstacle_overlap, crack_face_overlap,
          exempt_pairs, fragments, reactions, gauges, peak_strain, peak_stress, peak_bending_strain,
          peak_overload, peak_yield, yielding, fastest);
}

}  // namespace sherd
