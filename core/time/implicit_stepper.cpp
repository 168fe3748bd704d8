// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/implicit_stepper.h"

#include <algorithm>

#include "core/shell/inheritance.h"
#include "core/shell/supports.h"
#include "core/solver/newton.h"
#include "core/solver/newton_system.h"
#include "core/solver/quasi_newton.h"
#include "core/time/schemes/bdf2.h"
#include "core/time/schemes/implicit_euler.h"
#include "core/time/schemes/statics.h"

namespace sherd {
namespace {

std::unique_ptr<TimeScheme> time_scheme(Scheme scheme) {
    if (scheme == Scheme::statics) return std::make_unique<Statics>();
    if (scheme == Scheme::bdf2) return std::make_unique<Bdf2>();
    return std::make_unique<ImplicitEuler>();
}

std::unique_ptr<Minimiser> minimiser_of(const StepperOptions& options, const Threads& threads) {
    if (options.method == Method::newton) return std::make_unique<Newton>(options.tolerance);
    return std::make_unique<QuasiNewton>(options.tolerance, threads);
}

}  // namespace

ImplicitStepper::ImplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start)
    : Stepper(shell, options, start),
      scheme(time_scheme(options.scheme)),
      inertia(shell, options.scheme == Scheme::statics ? Vector3d::Zero() : options.gravity),
      loads(forces.loads()),
      threads(options.threads),
      elastic(shell, forces, options.shell, threads),
      contact(shell, options.contact, start.contact, options.gravity, threads),
      body_inertia(contact.of_bodies()),
      potential(shell, all_energies(), spent, threads, contact.body_masses()),
      minimiser(minimiser_of(options, threads)) {
    step = scheme->begin(shell, contact.bodies(), time, options.step);
    if (options.arc_length) path.emplace(shell, options.tolerance, options.last_load);
}

void ImplicitStepper::visit_state(StateVisitor& visit) {
    static_assert(has_only<ImplicitStepper, Stepper, decltype(step), decltype(scheme), decltype(inertia),
                           decltype(loads), decltype(threads), decltype(elastic), decltype(contact),
                           decltype(body_inertia), decltype(opening), decltype(potential),
                           decltype(minimiser), decltype(path), decltype(unbalanced)>());
    Stepper::visit_state(visit);
    visit(step, *scheme, inertia, elastic, contact, body_inertia, opening, *minimiser, unbalanced);
    if (path) visit(*path);
}

std::vector<Energy*> ImplicitStepper::all_energies() {
    std::vector<Energy*> all{&inertia, &elastic};
    for (const std::vector<Energy*>& some :
         {contact.energies(), {&body_inertia}, loads, contact.frictions(), {&opening}})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

StepResult ImplicitStepper::begin(double length) {
    step = scheme->begin(shell, contact.bodies(), time, length);
    // The shorter the step, the stiffer is inertia, and the larger the force that an error of the positions
    // leaves.
    const double shorter = step.inertia > 0 ? std::min(1.0, length / options.step) : 1;
    minimiser->set_tolerance(options.tolerance * shorter);
    if (path) path->begin(length, step);
    const double in_shell = elastic_at_start(step);
    potential.begin(step);
    ledger.begin(in_shell + contact.stored_at_start(), moving(shell.velocity, shell.position));
    opening.begin_step(step, shell.position);
    unbalanced.resize(3, 0);
    if (auto message = overlap()) return {Outcome::failed, std::move(*message)};
    return {predict() ? Outcome::done : Outcome::too_long};
}

bool ImplicitStepper::predict() {
    const Positions motion = inertia.predicted() - shell.position;
    position = inertia.predicted();
    if (free_fraction(motion) < 1 && !predict_in_two(motion)) return false;
    if (contact.empty()) return true;
    const Stopwatch watch(spent, Task::contact);
    contact.predict_bodies(position);
    return true;
}

bool ImplicitStepper::predict_in_two(const Positions& motion) {
    const Positions scripted = scripted_part(shell, motion);
    for (const bool along : {false, true}) {
        const Positions first = along ? scripted + push_displacement() : scripted;
        if (free_fraction(first) < 1) continue;
        position = shell.position + first;
        const Positions from = contact.with_bodies(position);
        Positions others = Positions::Zero(3, from.cols());
        others.leftCols(motion.cols()) = motion - first;
        position = (from + potential.safe_fraction(from, others) * others).leftCols(motion.cols());
        return true;
    }
    return false;
}

std::optional<std::string> ImplicitStepper::overlap() {
    if (contact.empty()) return std::nullopt;
    const Stopwatch watch(spent, Task::contact);
    return contact.overlap();
}

double ImplicitStepper::free_fraction(const Positions& motion) {
    if (contact.empty()) return 1;
    const Stopwatch watch(spent, Task::contact);
    return contact.free_fraction(motion);
}

Positions ImplicitStepper::push_displacement() const {
    Positions pushed = contact.push_displacement();
    constrain(shell, pushed);
    return pushed;
}

StepResult ImplicitStepper::solve(int max_iterations) {
    const Stopwatch watch(spent, Task::other);  // without the time that energies and solver account for
    StepResult result = minimise(max_iterations);
    if (result && !contact.empty()) {
        const Stopwatch of_contact(spent, Task::contact);
        if (contact.passes(step, position)) result.outcome = Outcome::passage;
    }
    ledger.solved(stored());
    opening.solved(position);
    unbalanced.resize(3, 0);
    return result;
}

StepResult ImplicitStepper::minimise(int max_iterations) {
    Positions unknowns = contact.with_bodies(position);
    StepResult result = minimise(max_iterations, unknowns);
    position = unknowns.leftCols(position.cols());
    contact.place_bodies(unknowns);
    return result;
}

StepResult ImplicitStepper::minimise(int max_iterations, Positions& unknowns) try {
    const MinimiserResult found = path ? path->solve(potential, loads, step, max_iterations, unknowns)
                                       : minimiser->minimise(potential, max_iterations, unknowns);
    return {found.converged ? Outcome::done : Outcome::unsolved, {}, found.iterations, found.limited};
} catch (const IndefiniteMatrix& error) {
    // With the inertia of a shorter step the matrix may be positive definite.
    return {Outcome::unsolved, error.what()};
}

void ImplicitStepper::topology_changed(const ShellChange& change) {
    opening.shell_changes();
    follow(position, change);
    opening.shell_changed(position);
    scheme->topology_changed(shell, change, step);
    potential.topology_changed(change, step);
    if (path)
        path->topology_changed(change, potential, position);
    else
        minimiser->topology_changed(change, potential, contact.with_bodies(position));
    const double gone =
        ledger.topology_changed(stored(), moving(shell.velocity, shell.position), change.remeshes());
    const Positions kept = newly_unbalanced(change.vertices);
    if (change.opening) opening.open(*change.opening, kept, position, gone);
}

Positions ImplicitStepper::newly_unbalanced(std::span<const IndexWithParents> inserted) {
    Positions before = unbalanced;
    if (before.cols() > 0) append(before, inserted);
    unbalanced = potential.gradient(contact.with_bodies(position)).leftCols(position.cols()) *
                 shell.mass.cwiseInverse().asDiagonal();
    return (before.cols() > 0 ? Positions(unbalanced - before) : unbalanced) * shell.mass.asDiagonal();
}

double ImplicitStepper::dissipated_by_scheme() {
    contact.end_step();
    return ledger.dissipated_by_scheme(work(), stored());
}

void ImplicitStepper::finish() {
    contact.finish(position);
    const StepWork of_step = work();
    ledger.finish(of_step, stored(), moving(step.velocity(position), position));
    forces.store_plastic_curvature(position);
    if (path) path->finish(step, position);
    scheme->finish(step, position, shell);
    opening.finish();
    time = step.end();
}

std::vector<Reaction> ImplicitStepper::reactions() const {
    std::vector<Reaction> all(options.supports);
    if (options.supports > 0) {
        // The inertial prediction satisfies the supports, so that inertia has no force against them in the
        // potential.
        Positions blocked =
            potential.gradient_with_blocked(contact.with_bodies(position)).leftCols(position.cols());
        if (step.inertia > 0) {  // in statics, weight is one of the loads
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

void ImplicitStepper::add_inertia(EnergyBalance& balance, Positions& gradient) const {
    if (step.inertia == 0) return;
    const Positions force = step.acceleration(position) * shell.mass.asDiagonal();
    gradient += force - options.gravity * shell.mass.transpose();
    balance.lost_to_scheme = force.cwiseProduct(position - shell.position).sum() -
                             kinetic_energy(shell.mass, step.velocity(position)) + kinetic_energy(shell);
    if (const BodyContact* bodies = contact.of_bodies())
        balance.lost_to_scheme += bodies->work_of_all() - bodies->kinetic_change();
}

StepWork ImplicitStepper::work() {
    const Positions moved = position - shell.position;
    Positions gradient = Positions::Zero(3, position.cols());
    elastic.add_gradient(position, gradient);
    contact.add_gradient(position, gradient);
    opening.add_gradient(position, gradient);
    StepWork all;
    all.against_stored = gradient.cwiseProduct(moved).sum();
    if (const BodyContact* bodies = contact.of_bodies()) all.against_stored -= bodies->contact_work();
    EnergyBalance& balance = all.balance;
    forces.add_outer(position, moved, balance, gradient);
    add_inertia(balance, gradient);
    balance.lost_to_cracks = opening.taken();
    Positions free = gradient;
    constrain(shell, free);
    const double of_mirrors = forces.mirror_work(step, position);
    balance.work_of_supports = (gradient - free).cwiseProduct(moved).sum() + of_mirrors;
    balance.work_of_obstacles = contact.obstacle_work(step, position);
    balance.lost_to_friction = contact.friction_loss(position);
    balance.lost_to_yield = forces.dissipated_by_yielding(position);
    all.against_stored += of_mirrors + balance.work_of_obstacles - balance.lost_to_friction -
                          balance.lost_to_yield - balance.lost_to_cracks;
    return all;
}

}  // namespace sherd
