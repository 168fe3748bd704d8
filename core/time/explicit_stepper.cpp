// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/explicit_stepper.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/shell/patch_momentum.h"
#include "core/shell/supports.h"
#include "core/time/highest_frequency.h"

namespace sherd {
namespace {

/// Share of the stable substep that is taken: the estimate comes from below, and contact and large motions
/// stiffen.
constexpr double safety = 0.8;
/// Contact begins and ends within a substep, which errs in energy by the square of substep times frequency:
/// it therefore has a third of the longest one.
constexpr double resolution_of_contact = 3;
/// Growth of the largest strain after which the highest frequency is estimated anew: the membrane's stiffness
/// along a stretch grows by three times as much.
constexpr double growth = 0.05;
constexpr double most_substeps = 1e6;  // in a step; more say that positions have run away

void require_stable(bool is_stable) {
    if (!is_stable)
        throw std::runtime_error(
            "explicit steps have become unstable: a shorter solver.step, or softer contact, may help");
}

std::vector<Reaction> means(std::vector<Reaction> some, std::span<const Reaction> others) {
    for (std::size_t i = 0; i < some.size(); ++i) {
        some[i].force = 0.5 * (some[i].force + others[i].force);
        some[i].moment = 0.5 * (some[i].moment + others[i].moment);
    }
    return some;
}

/// Masses, kg, [V], without those of what is told where to be.
VectorXd free_mass(const Shell& shell) {
    VectorXd mass = shell.mass;
    for (Index v = 0; v < static_cast<Index>(mass.size()); ++v)
        if (shell.fixed[v]) mass[v] = 0;
    return mass;
}

}  // namespace

ExplicitStepper::ExplicitStepper(Shell& shell, const StepperOptions& options)
    : Stepper(shell, options),
      contact(shell, options.contact, options.gravity),
      elastic(forces.elastic()),
      step{0, options.step, options.step, shell.position, shell.velocity, {}},
      length(options.step),
      velocity(shell.velocity),
      acceleration(Positions::Zero(3, shell.position.cols())) {}

Positions ExplicitStepper::Forces::sum() const {
    Positions all = elastic + contact.force + damping + opening;
    for (const Positions& one : outer) all += one;
    return all;
}

bool ExplicitStepper::begin(double of_step) {
    if (made) contact.of_bodies().restart();
    step = {time, of_step, of_step, shell.position, shell.velocity, {}};
    position = shell.position;
    velocity = shell.velocity;
    contact.of_bodies().begin();
    contact.place(time, time);
    if (first || made) {
        energies_now.reset();
        place_clamps_at_start(step);
    }
    for (Energy* energy : forces.loads()) energy->begin(step);
    ledger.begin(stored(), moving(velocity, position));
    work = {};
    inertia_work = 0;
    choose_substep();
    if (first || made) feel();
    first = made = false;
    return true;
}

void ExplicitStepper::choose_substep() {
    const Stopwatch watch(spent, Task::elasticity);
    const double strain = forces.face_strains(shell.position).cwiseAbs().maxCoeff();
    // Every crack counts: what it leaves alone may be a face that swings far faster than with its neighbours.
    if (changed || strain > strain_then + growth) {
        of_shell = highest_frequency(elastic, shell, shell.position, mode);
        changed = false;
        strain_then = strain;
    }
    // With the fall in the step: what lies at rest, just touching, is in contact in a moment.
    Positions motion = step.length * shell.velocity;
    motion.colwise() += step.length * step.length * options.gravity;
    const double of_contact = resolution_of_contact * std::sqrt(contact.largest_rate(shell.position, motion));
    const double highest = std::hypot(of_shell, of_contact);
    const double damped = 0.5 * options.shell.damping.stiffness * highest;
    const double stable = safety * 2 / highest * (std::sqrt(1 + damped * damped) - damped);
    require_stable(step.length < most_substeps * stable);
    substeps = std::max(1, static_cast<int>(std::ceil(step.length / stable - 1e-9)));
    length = step.length / substeps;
}

void ExplicitStepper::visit_state(StateVisitor& visit) {
    static_assert(
        has_only<ExplicitStepper, Stepper, decltype(contact), decltype(opening), decltype(elastic),
                 decltype(step), decltype(time), decltype(of_shell), decltype(substeps), decltype(length),
                 decltype(first), decltype(made), decltype(changed), decltype(strain_then), decltype(mode),
                 decltype(velocity), decltype(acceleration), decltype(forces_now), decltype(energies_now),
                 decltype(work), decltype(inertia_work)>());
    Stepper::visit_state(visit);
    visit(contact, opening, step, time, of_shell, substeps, length, first, made, changed, strain_then, mode,
          velocity, acceleration, forces_now, energies_now, work, inertia_work);
}

ExplicitStepper::Forces ExplicitStepper::forces_at(const Positions& now) {
    Forces all;
    all.elastic = all.damping = Positions::Zero(3, position.cols());
    {
        const Stopwatch watch(spent, Task::elasticity);
        for (const Energy* energy : elastic) energy->add_gradient(position, all.elastic);
        all.elastic *= -1;
    }
    for (const OuterEnergy& outer : forces.outer()) {
        const Stopwatch watch(spent, Task::loads);
        Positions gradient = Positions::Zero(3, position.cols());
        outer.energy->add_gradient(outer.of_velocity ? Positions(step.origin + step.lag * now) : position,
                                   gradient);
        all.outer.push_back(-gradient);
    }
    all.opening = Positions::Zero(3, position.cols());
    opening.add_forces(all.opening);
    const Stopwatch watch(spent, Task::contact);
    all.contact = contact.forces({length, position, now});
    return all;
}

void ExplicitStepper::feel() {
    forces_now = forces_at(velocity);
    accelerate();
}

void ExplicitStepper::accelerate() {
    acceleration = forces_now.sum() * shell.mass.cwiseInverse().asDiagonal();
    acceleration.colwise() += options.gravity;
    constrain(shell, acceleration);
}

MinimiserResult ExplicitStepper::solve(int) {
    const Stopwatch watch(spent, Task::other);  // except what is booked elsewhere
    if (made) return {0, true, 0};
    for (int i = 0; i < substeps; ++i) make_substep(step.begin + step.length * i / substeps);
    energies_now.reset();
    made = true;
    const VectorXd mass = free_mass(shell);
    work.balance.lost_to_scheme =
        inertia_work - kinetic_energy(mass, velocity) + kinetic_energy(mass, shell.velocity);
    ledger.moves(moving(velocity, position));
    require_stable(position.allFinite());
    contact.require_no_passage(step, position);
    ledger.solved(stored());
    return {substeps, true, 0};
}

PotentialEnergies ExplicitStepper::elastic_energies() const {
    if (!energies_now) energies_now = Stepper::elastic_energies();
    return *energies_now;
}

Positions ExplicitStepper::move(double end) {
    const Positions before = position;
    velocity += length / 2 * acceleration;
    position += length * velocity;
    place_scripted(shell, end, position);
    Positions moved = position - before;
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0) {
            const Vector3d now = moved.col(v) / length;
            const double change = 0.5 * shell.mass[v] * (now.squaredNorm() - velocity.col(v).squaredNorm());
            work.balance.work_of_supports += change - shell.mass[v] * options.gravity.dot(moved.col(v));
            velocity.col(v) = now;
        }
    return moved;
}

void ExplicitStepper::make_substep(double from) {
    StepContext substep;
    substep.begin = from;
    substep.length = length;
    contact.of_bodies().kick(length);
    const Positions moved = move(substep.end());
    contact.of_bodies().drift(length);
    contact.place(from, substep.end());
    if (forces.mirrors_move())
        for (Energy* energy : elastic) energy->begin(substep);
    opening.fade(moved, length);
    const Forces before = std::move(forces_now);
    const Positions acceleration_before = acceleration;
    forces_now = forces_at(velocity);
    if (options.shell.damping.stiffness > 0)
        forces_now.damping = options.shell.damping.stiffness / length * (forces_now.elastic - before.elastic);
    accelerate();
    velocity += length / 2 * acceleration;
    contact.of_bodies().kick(length);
    const double of_mirrors = forces.mirror_work(substep, position);
    work.balance.work_of_supports += of_mirrors;
    work.against_stored += of_mirrors;
    inertia_work +=
        0.5 * ((acceleration_before + acceleration).cwiseProduct(moved).colwise().sum() * shell.mass).value();
    enter(before, moved);
}

void ExplicitStepper::enter(const Forces& before, const Positions& moved) {
    const auto taken = [&](const Positions& one, const Positions& other) {
        return -0.5 * (one.cwiseProduct(moved).sum() + other.cwiseProduct(moved).sum());
    };
    EnergyBalance& balance = work.balance;
    balance.lost_to_damping += taken(before.damping, forces_now.damping);
    balance.lost_to_cracks += taken(before.opening, forces_now.opening);
    for (std::size_t i = 0; i < before.outer.size(); ++i)
        balance.take(forces.outer()[i].part, taken(before.outer[i], forces_now.outer[i]));
    const ContactForces &then = before.contact, &now = forces_now.contact;
    const double of_obstacles = contact.obstacle_work(means(then.obstacles, now.obstacles));
    const double of_friction = taken(then.friction, now.friction) +
                               contact.obstacle_work(means(then.obstacle_friction, now.obstacle_friction));
    balance.work_of_obstacles += of_obstacles;
    balance.lost_to_friction += of_friction;
    work.against_stored +=
        taken(before.elastic, forces_now.elastic) + taken(then.force, now.force) + of_obstacles - of_friction;
    // What moves scripted vertices works against all forces on them.
    const Positions both = before.sum() + forces_now.sum();
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0) balance.work_of_supports -= 0.5 * both.col(v).dot(moved.col(v));
}

void ExplicitStepper::topology_changed(const ShellChange& change) {
    follow_in_motion(shell, change, position, velocity);
    if (mode.cols() > 0) follow(mode, change);
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
    for (Energy* energy : elastic) energy->topology_changed(change, step);
    for (Energy* energy : forces.loads()) energy->topology_changed(change, step);
    contact.shell_changed(change);
    changed = true;
    energies_now.reset();
    append(acceleration, change.vertices);
    const Positions before = acceleration;
    feel();
    const double gone = ledger.topology_changed(stored(), moving(velocity, position), change.remeshes());
    if (!change.opening) return;
    opening.open(*change.opening, kept_forces(before), gone);
    forces_now.opening.setZero();
    opening.add_forces(forces_now.opening);
    accelerate();
}

Positions ExplicitStepper::kept_forces(const Positions& before) const {
    Positions kept = (before - acceleration) * shell.mass.asDiagonal();
    constrain(shell, kept);
    return kept;
}

void ExplicitStepper::finish() {
    const ExplicitBodies& bodies = contact.of_bodies();
    work.against_stored -= bodies.contact_work() - bodies.friction_work();
    work.balance.lost_to_friction -= bodies.friction_work();
    work.balance.lost_to_scheme += bodies.work_of_all() - bodies.kinetic_change();
    ledger.finish(work, stored(), moving(velocity, position));
    shell.position = position;
    shell.velocity = velocity;
    time = step.end();
    made = false;
}

std::vector<Reaction> ExplicitStepper::reactions() const {
    std::vector<Reaction> all(options.supports);
    if (options.supports > 0) {
        // On what is held: mass times acceleration, which is zero where nothing moves it, less all forces.
        Positions blocked = -forces_now.sum();
        blocked -= options.gravity * shell.mass.transpose();
        Positions free = blocked;
        constrain(shell, free);
        add_reactions(shell, position, blocked - free, all);
        forces.add_mirror_reactions(position, all);
    }
    all.insert(all.end(), forces_now.contact.obstacles.begin(), forces_now.contact.obstacles.end());
    return all;
}

}  // namespace sherd
