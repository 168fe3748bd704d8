// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time_step.h"

#include "core/contact/sheet_friction.h"

namespace sherd {

TimeStep::TimeStep(Sheet& sheet, const TimeStepOptions& options)
    : position(sheet.position),
      sheet(sheet),
      options(options),
      step(options.step),
      bending(sheet.hinges, options.bending),
      membrane(sheet.triangles),
      mirror_hinges(options.mirrors),
      mirrors(sheet, mirror_hinges),
      lips(sheet.lips),
      start_bodies(options.bodies),
      moved_bodies(options.bodies) {
    if (options.sheet_contact) sheet_contact = std::make_unique<SheetContact>(sheet);
}

void TimeStep::carry_mirrors() {
    for (std::size_t i = 0; i < mirror_hinges.size(); ++i)
        if (const Index carrier = options.mirrors[i].carrier; carrier != 0)
            mirror_hinges[i] = moved(options.mirrors[i], sheet.motions[carrier - 1].at(start + step));
}

void TimeStep::prepare_loads() {
    const Stopwatch watch(spent, Task::loads);
    of_step.clear();
    if (!options.loads.empty())
        of_step.push_back(std::make_unique<LoadEnergy>(sheet, options.loads, start + step));
    if (!options.winds.empty())
        of_step.push_back(std::make_unique<WindEnergy>(sheet, options.winds, start + step, step));
    if (options.damping.stiffness > 0)
        of_step.push_back(std::make_unique<StiffnessDamping>(sheet, options.damping.stiffness, step));
    if (options.damping.mass > 0)
        of_step.push_back(std::make_unique<MassDamping>(sheet, options.damping.mass, step));
}

void TimeStep::prepare_contact() {
    if (!sheet_contact && options.obstacles.empty() && start_bodies.empty()) return;
    const Stopwatch watch(spent, Task::contact);
    if (sheet_contact && options.sheet_friction > 0)
        of_step.push_back(
            std::make_unique<SheetFriction>(sheet, *sheet_contact, options.sheet_friction, step));
    obstacle_contact.clear();
    for (const Obstacle& obstacle : options.obstacles)
        obstacle_contact.emplace_back(sheet, obstacle, start, step);
    body_contact.clear();
    for (const RigidBody& body : start_bodies)
        body_contact.emplace_back(sheet, body, this->options.obstacles, options.gravity, start, step);
}

void TimeStep::prepare() {
    carry_mirrors();
    prepare_loads();
    prepare_contact();
    std::vector<const Energy*> energies{&bending, &membrane, &mirrors};
    for (const BodyContact& contact : body_contact) energies.push_back(&contact);
    for (const ObstacleContact& contact : obstacle_contact) energies.push_back(&contact);
    if (sheet_contact) {
        energies.push_back(sheet_contact.get());
        energies.push_back(&lips);
    }
    for (const std::unique_ptr<Energy>& energy : of_step) energies.push_back(energy.get());
    potential = std::make_unique<IncrementalPotential>(sheet, std::move(energies), step, options.gravity,
                                                       spent, start + step);
}

bool TimeStep::predict() {
    const Positions motion = potential->predicted() - sheet.position;
    const double fraction = potential->safe_fraction(sheet.position, motion);
    position = fraction == 1 ? potential->predicted() : sheet.position + fraction * motion;
    if (fraction == 1 || sheet.motions.empty()) return true;
    // What is carried has to arrive, so it goes first, and the others as far as there is room.
    Positions carried = motion;
    for (std::size_t v = 0; v < sheet.carrier.size(); ++v)
        if (sheet.carrier[v] == 0) carried.col(v).setZero();
    if (potential->safe_fraction(sheet.position, carried) < 1) return false;
    const Positions others = motion - carried;
    position = sheet.position + carried;
    position += potential->safe_fraction(position, others) * others;
    return true;
}

bool TimeStep::begin(double length) {
    step = length;
    start = time;
    start_bodies = moved_bodies;
    prepare();
    if (sheet_contact) {
        const Stopwatch watch(spent, Task::contact);
        sheet_contact->require_apart(sheet.position);
    }
    const bool carried = predict();
    if (!system) system = std::make_unique<NewtonSystem>(*potential, position);
    return carried;
}

NewtonResult TimeStep::solve(int max_iterations) {
    const Stopwatch watch(spent, Task::other);  // but for what its parts book
    NewtonOptions newton = options.newton;
    newton.max_iterations = max_iterations;
    return minimise(*potential, *system, newton, position);
}

void TimeStep::stencils_changed() {
    if (sheet_contact) {
        const Stopwatch watch(spent, Task::contact);
        sheet_contact->surface_changed();
    }
    prepare();
    system = std::make_unique<NewtonSystem>(*potential, position);
}

void TimeStep::finish() {
    for (std::size_t i = 0; i < body_contact.size(); ++i) moved_bodies[i] = body_contact[i].moved(position);
    sheet.velocity = (position - sheet.position) / step;
    sheet.position = position;
    time = start + step;
}

PotentialEnergies TimeStep::energies() const {
    PotentialEnergies sum;
    sum.bending = bending.value(position) + mirrors.value(position);
    sum.membrane = membrane.value(position);
    sum.gravity = -options.gravity.dot(position * sheet.mass);
    for (const ObstacleContact& contact : obstacle_contact) sum.contact += contact.stored_energy(position);
    for (const BodyContact& contact : body_contact) sum.contact += contact.stored_energy(position);
    for (const RigidBody& body : moved_bodies) sum.gravity -= body.mass * options.gravity.dot(body.centre);
    if (sheet_contact) sum.contact += sheet_contact->value(position) + lips.value(position);
    return sum;
}

Touch TimeStep::touch() const {
    Touch touch;
    for (const ObstacleContact& contact : obstacle_contact) touch.include(contact.touch(position));
    for (const BodyContact& contact : body_contact) touch.include(contact.touch(position));
    return touch;
}

}  // namespace sherd
