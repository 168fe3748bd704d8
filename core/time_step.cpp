// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time_step.h"

#include <algorithm>

#include "core/contact/contact_solids.h"
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
    std::vector<ContactSolid> solids = contact_solids(sheet, options.obstacles);
    if (options.sheet_contact || !solids.empty())
        sheet_contact = std::make_unique<SheetContact>(sheet, std::move(solids), options.sheet_contact);
    for (const RigidBody& body : options.bodies)
        body_pairs.push_back(body.surface ? std::make_unique<NearPairs>(surface_with(sheet, body)) : nullptr);
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
    if (sheet_contact) {
        sheet_contact->place_solids(solid_positions(options.obstacles, start),
                                    solid_positions(options.obstacles, start + step));
        of_step.push_back(
            std::make_unique<SheetFriction>(sheet, *sheet_contact, options.sheet_friction, step));
    }
    obstacle_contact.clear();
    for (const Obstacle& obstacle : options.obstacles)
        obstacle_contact.emplace_back(sheet, obstacle, start, step);
    prepare_bodies();
}

void TimeStep::prepare() {
    carry_mirrors();
    prepare_loads();
    prepare_contact();
    std::vector<const Energy*> energies{&bending, &membrane, &mirrors};
    if (body_contact) energies.push_back(body_contact.get());
    for (const ObstacleContact& contact : obstacle_contact) energies.push_back(&contact);
    if (sheet_contact) energies.push_back(sheet_contact.get());
    if (options.sheet_contact) energies.push_back(&lips);
    for (const std::unique_ptr<Energy>& energy : of_step) energies.push_back(energy.get());
    potential = std::make_unique<IncrementalPotential>(sheet, std::move(energies), step, options.gravity,
                                                       spent, start + step);
}

void TimeStep::prepare_bodies() {
    if (start_bodies.empty()) return;
    std::vector<BodyStep> steps;
    for (std::size_t i = 0; i < start_bodies.size(); ++i)
        steps.emplace_back(sheet, start_bodies[i], options.obstacles, options.gravity, start, step,
                           body_pairs[i].get());
    const VectorXd apart =
        body_contact ? body_contact->apart() : VectorXd(VectorXd::Zero(6 * start_bodies.size()));
    body_contact = std::make_unique<BodyContact>(std::move(steps), step, apart);
}

Positions TimeStep::carried(const Positions& motion) const {
    Positions carried = motion;
    for (std::size_t v = 0; v < sheet.carrier.size(); ++v)
        if (sheet.carrier[v] == 0) carried.col(v).setZero();
    return carried;
}

Positions TimeStep::taken_along(const Positions& motion) {
    if (!sheet_contact) return carried(motion);
    const Stopwatch watch(spent, Task::contact);
    Positions taken = sheet_contact->taken_along(sheet.position);
    potential->constrain(taken);
    return carried(motion) + taken;
}

bool TimeStep::predict() {
    const Positions motion = potential->predicted() - sheet.position;
    const auto free_way = [&](const Positions& way) {
        if (!sheet_contact && !body_contact) return 1.0;
        const Stopwatch watch(spent, Task::contact);
        double fraction = sheet_contact ? sheet_contact->safe_fraction_of_step(sheet.position, way) : 1;
        if (body_contact) fraction = std::min(fraction, body_contact->safe_fraction(sheet.position, way));
        return fraction;
    };
    const double fraction = free_way(motion);
    position = potential->predicted();
    if (fraction == 1) return true;
    // What is carried has to arrive, and obstacles too, so they go first, if need be with what is near them,
    // and the others as far as there is room.
    for (const bool along : {false, true}) {
        const Positions first = along ? taken_along(motion) : carried(motion);
        if (free_way(first) < 1) continue;
        const Positions others = motion - first;
        position = sheet.position + first;
        position += potential->safe_fraction(position, others) * others;
        return true;
    }
    return false;
}

bool TimeStep::begin(double length) {
    step = length;
    start = time;
    start_bodies = moved_bodies;
    body_contact = nullptr;
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

void TimeStep::change_surface() {
    if (!sheet_contact && body_pairs.empty()) return;
    const Stopwatch watch(spent, Task::contact);
    if (sheet_contact) sheet_contact->surface_changed();
    for (std::size_t i = 0; i < body_pairs.size(); ++i)
        if (body_pairs[i]) body_pairs[i]->surface_changed(surface_with(sheet, start_bodies[i]));
}

void TimeStep::stencils_changed() {
    change_surface();
    prepare();
    system = std::make_unique<NewtonSystem>(*potential, position);
}

void TimeStep::finish() {
    if (body_contact) moved_bodies = body_contact->moved(position);
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
    if (body_contact) sum.contact += body_contact->stored_energy(position);
    for (const RigidBody& body : moved_bodies) sum.gravity -= body.mass * options.gravity.dot(body.centre);
    if (sheet_contact) sum.contact += sheet_contact->value(position);
    if (options.sheet_contact) sum.contact += lips.value(position);
    return sum;
}

Touch TimeStep::touch() const {
    Touch touch;
    std::set<const SolidSurface*> surfaces;
    if (sheet_contact) sheet_contact->add_touched(position, touch.vertices, surfaces);
    for (std::size_t o = 0; o < obstacle_contact.size(); ++o) {
        Touch own;
        obstacle_contact[o].add_touch(position, own);
        if (!own.vertices.empty() || surfaces.contains(options.obstacles[o].surface.get()))
            touch.obstacles.insert(o);
        touch.include(own);
    }
    if (body_contact) body_contact->add_touch(position, touch);
    return touch;
}

}  // namespace sherd
