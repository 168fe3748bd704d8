// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/implicit_stepper.h"

#include "core/shell/supports.h"
#include "core/time/implicit_euler.h"
#include "core/time/statics.h"

namespace sherd {
namespace {

std::unique_ptr<TimeScheme> time_scheme(Scheme scheme) {
    if (scheme == Scheme::statics) return std::make_unique<Statics>();
    return std::make_unique<ImplicitEuler>();
}

/// In statics weight is a load like others: it grows with the load factor.
Load weight(const Shell& shell, const Vector3d& gravity) {
    Load load;
    for (Index t = 0; t < static_cast<Index>(shell.triangles.size()); ++t)
        for (int corner = 0; corner < 3; ++corner)
            load.dead.push_back({t, corner, shell.face_mass[t] / 3 * gravity});
    return load;
}

ShellEnergyOptions shell_options(const Shell& shell, const StepperOptions& options) {
    ShellEnergyOptions all = options.shell;
    if (options.scheme == Scheme::statics && !options.gravity.isZero(0))
        all.loads.push_back(weight(shell, options.gravity));
    return all;
}

}  // namespace

ImplicitStepper::ImplicitStepper(Shell& shell, const StepperOptions& options)
    : position(shell.position),
      shell(shell),
      options(options),
      scheme(time_scheme(options.scheme)),
      inertia(shell, options.scheme == Scheme::statics ? Vector3d::Zero() : options.gravity),
      forces(shell, shell_options(shell, options)),
      loads(forces.loads()),
      contact(shell, options.contact, options.gravity),
      ledger(shell, forces, contact, options.gravity, options.scheme != Scheme::statics),
      potential(shell, all_energies(), spent),
      minimiser(std::make_unique<Newton>(options.tolerance)) {
    step = scheme->begin(shell, contact.bodies(), time, options.step);
    if (options.arc_length) path.emplace(shell, options.tolerance, options.last_load);
}

std::vector<Energy*> ImplicitStepper::all_energies() {
    std::vector<Energy*> all{&inertia};
    for (const std::vector<Energy*>& some :
         {forces.elastic(), contact.energies(), loads, contact.frictions()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

bool ImplicitStepper::begin(double length) {
    step = scheme->begin(shell, contact.bodies(), time, length);
    if (path) path->begin(length, step);
    ledger.begin(step);
    potential.begin(step);
    ledger.begun();
    require_apart();
    return predict();
}

bool ImplicitStepper::predict() {
    const Positions motion = inertia.predicted() - shell.position;
    position = inertia.predicted();
    if (free_way(motion) == 1) return true;
    // Scripted vertices and obstacles have to arrive, so they move first, if necessary together with what
    // they push. The other vertices follow as far as there is room.
    const Positions scripted = scripted_part(shell, motion);
    for (const bool along : {false, true}) {
        const Positions first = along ? scripted + pushed_along() : scripted;
        if (free_way(first) < 1) continue;
        const Positions others = motion - first;
        position = shell.position + first;
        potential.moved_to(position);
        position += potential.safe_fraction(position, others) * others;
        return true;
    }
    return false;
}

void ImplicitStepper::require_apart() {
    if (contact.empty()) return;
    const Stopwatch watch(spent, Task::contact);
    contact.require_apart();
}

double ImplicitStepper::free_way(const Positions& motion) {
    if (contact.empty()) return 1;
    const Stopwatch watch(spent, Task::contact);
    return contact.free_way(motion);
}

Positions ImplicitStepper::pushed_along() const {
    Positions pushed = contact.pushed_along();
    constrain(shell, pushed);
    return pushed;
}

MinimiserResult ImplicitStepper::solve(int max_iterations) {
    const Stopwatch watch(spent, Task::other);  // except what the energies and the solver book themselves
    const MinimiserResult result = path ? path->solve(potential, loads, step, max_iterations, position)
                                        : minimiser->minimise(potential, max_iterations, position);
    ledger.solved(position);
    return result;
}

void ImplicitStepper::topology_changed(const ShellChange& change) {
    append(position, change.vertices);
    scheme->topology_changed(shell, change, step);
    potential.topology_changed(change, step);
    if (path)
        path->topology_changed(change, potential, position);
    else
        minimiser->topology_changed(change, potential, position);
    ledger.topology_changed(position);
}

void ImplicitStepper::finish() {
    contact.finish(position);
    ledger.finish(step, position);
    if (path) path->finish(step, position);
    scheme->finish(step, position, shell);
    time = step.end();
}

std::vector<Reaction> ImplicitStepper::reactions() const {
    std::vector<Reaction> all(options.supports);
    if (options.supports > 0) {
        // The inertial prediction is where supports leave it, so that inertia has no force against them.
        Positions blocked = potential.gradient_with_blocked(position);
        if (step.inertia > 0) {  // else weight is one of the loads
            Positions acceleration = step.acceleration(position);
            acceleration.colwise() -= options.gravity;
            blocked += acceleration * shell.mass.asDiagonal();
        }
        add_reactions(shell, position, blocked, all);
        forces.add_mirror_reactions(position, all);
    }
    const Stopwatch watch(spent, Task::contact);
    const std::vector<Reaction> of_obstacles = contact.reactions(position);
    all.insert(all.end(), of_obstacles.begin(), of_obstacles.end());
    return all;
}

PotentialEnergies ImplicitStepper::energies() const {
    PotentialEnergies sum;
    sum.bending = forces.bending_value(position);
    sum.membrane = forces.membrane_value(position);
    sum.gravity = -step.load * options.gravity.dot(position * shell.mass);
    for (const RigidBody& body : bodies()) sum.gravity -= body.mass * options.gravity.dot(body.centre);
    sum.contact = contact.stored_energy(position);
    return sum;
}

}  // namespace sherd
