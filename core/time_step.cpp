// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time_step.h"

namespace sherd {

TimeStep::TimeStep(Sheet& sheet, const TimeStepOptions& options)
    : position(sheet.position),
      sheet(sheet),
      options(options),
      bending(sheet.hinges, options.bending),
      membrane(sheet.triangles) {
    for (const Plane& plane : options.planes) contact.emplace_back(sheet, plane, options.step);
}

std::unique_ptr<IncrementalPotential> TimeStep::potential_of_step() const {
    std::vector<const Energy*> energies{&bending, &membrane};
    for (const PlaneContact& plane : contact) energies.push_back(&plane);
    return std::make_unique<IncrementalPotential>(sheet, std::move(energies), options.step, options.gravity);
}

void TimeStep::begin() {
    potential = potential_of_step();
    if (!system) system = std::make_unique<NewtonSystem>(*potential);
    position = potential->predicted();
}

NewtonResult TimeStep::solve(int max_iterations) {
    NewtonOptions newton = options.newton;
    newton.max_iterations = max_iterations;
    return minimise(*potential, *system, newton, position);
}

void TimeStep::stencils_changed() {
    potential = potential_of_step();
    system = std::make_unique<NewtonSystem>(*potential);
}

void TimeStep::finish() {
    sheet.velocity = (position - sheet.position) / options.step;
    sheet.position = position;
}

PotentialEnergies TimeStep::energies() const {
    PotentialEnergies sum;
    sum.bending = bending.value(position);
    sum.membrane = membrane.value(position);
    sum.gravity = -options.gravity.dot(position * sheet.mass);
    for (const PlaneContact& plane : contact) sum.contact += plane.stored_energy(position);
    return sum;
}

Index TimeStep::contacts() const {
    Index count = 0;
    for (const PlaneContact& plane : contact) count += plane.contacts(position);
    return count;
}

}  // namespace sherd
