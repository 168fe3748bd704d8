// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/energy_ledger.h"

#include "core/shell/supports.h"

namespace sherd {

double EnergyLedger::weight(const Positions& x) const {
    if (!dynamic) return 0;
    double sum = -gravity.dot(x * shell.mass);
    for (const RigidBody& body : contact.bodies()) sum -= body.mass * gravity.dot(body.centre);
    return sum;
}

double EnergyLedger::kinetic(const Positions& velocity) const {
    if (!dynamic) return 0;
    double sum = 0.5 * velocity.colwise().squaredNorm().dot(shell.mass);
    for (const RigidBody& body : contact.bodies()) sum += body.kinetic_energy();
    return sum;
}

void EnergyLedger::begin(const StepContext& step) {
    StepContext still = step;
    still.length = 0;  // clamps stand where they are when the step begins
    for (Energy* energy : forces.elastic()) energy->begin(still);
    at_begin = elastic_energy(shell.position);
    opened = 0;
}

void EnergyLedger::begun() {
    at_begin += contact.stored_at_start();
    if (started) return;
    started = true;
    at_rest = at_begin;
    total = kinetic(shell.velocity) + at_rest + weight(shell.position);
}

void EnergyLedger::topology_changed(const Positions& x) {
    const double after = stored_energy(x);
    opened += stored - after;
    stored = after;
}

void EnergyLedger::add_inertia(const StepContext& step, const Positions& x, EnergyBalance& now,
                               Positions& gradient) const {
    if (!dynamic) return;
    const Positions force = step.acceleration(x) * shell.mass.asDiagonal();
    gradient += force;
    gradient -= gravity * shell.mass.transpose();
    double change = kinetic(step.velocity(x)) - kinetic(shell.velocity), of_all = 0;
    if (const BodyContact* bodies = contact.of_bodies()) {
        for (const RigidBody& body : contact.bodies()) change += body.kinetic_energy();
        change -= bodies->kinetic_before();
        of_all = bodies->work_of_all();
    }
    now.lost_to_scheme += force.cwiseProduct(x - shell.position).sum() + of_all - change;
}

void EnergyLedger::finish(const StepContext& step, const Positions& x) {
    const Positions moved = x - shell.position;
    EnergyBalance now;
    Positions gradient = Positions::Zero(3, x.cols());
    for (const Energy* energy : forces.elastic()) energy->add_gradient(x, gradient);
    for (const Energy* energy : contact.energies()) energy->add_gradient(x, gradient);
    for (const Energy* energy : contact.frictions()) energy->add_gradient(x, gradient);
    double taken = gradient.cwiseProduct(moved).sum();
    if (const BodyContact* bodies = contact.of_bodies()) taken -= bodies->contact_work();

    forces.add_outer(x, moved, now, gradient);
    add_inertia(step, x, now, gradient);
    Positions free = gradient;
    constrain(shell, free);
    const double of_mirrors = forces.mirror_work(step, x);
    now.work_of_supports = (gradient - free).cwiseProduct(moved).sum() + of_mirrors;
    now.work_of_obstacles = contact.obstacle_work(step, x);
    now.lost_to_friction = contact.friction_loss(x);

    const double at_end = stored_energy(x);
    now.lost_to_scheme +=
        taken + of_mirrors + now.work_of_obstacles - now.lost_to_friction - (at_end - at_begin) - opened;
    now.lost_to_cracks = opened + at_rest - at_begin;
    at_rest = at_end;
    const double before = total;
    total = kinetic(step.velocity(x)) + at_end + weight(x);
    now.unexplained = total - before -
                      (now.work_of_loads + now.work_of_wind + now.work_of_supports + now.work_of_obstacles) +
                      now.lost_to_friction + now.lost_to_damping + now.lost_to_cracks + now.lost_to_scheme;
    all += now;
}

}  // namespace sherd
