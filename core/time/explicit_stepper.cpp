// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/explicit_stepper.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/shell/patch_momentum.h"
#include "core/shell/supports.h"
#include "core/time/stable_substep.h"

namespace sherd {
namespace {

/// Contact that begins or ends within a substep causes an error in energy of the order of (substep times
/// frequency) squared: substeps with contact have a third of the stable length.
constexpr double resolution_of_contact = 3;
/// Growth of the largest strain after which the highest frequency is estimated again: the membrane's
/// stiffness along a stretch grows by three times this share.
constexpr double growth = 0.05;
constexpr int most_again = 50'000;  // substeps of a repeated step; with more, the program would seem to hang
constexpr Index vertices_at_once = 512;

/// The coordinates of the vertices from `begin` to before `end`, one after the other.
Eigen::Map<Eigen::ArrayXd> range_of(Positions& all, Index begin, Index end) {
    return {all.data() + 3 * begin, 3 * (end - begin)};
}
Eigen::Map<const Eigen::ArrayXd> range_of(const Positions& all, Index begin, Index end) {
    return {all.data() + 3 * begin, 3 * (end - begin)};
}

/// Masses, kg, [V], zero for fixed vertices.
VectorXd free_mass(const Shell& shell) {
    VectorXd mass = shell.mass;
    for (Index v = 0; v < static_cast<Index>(mass.size()); ++v)
        if (shell.fixed[v]) mass[v] = 0;
    return mass;
}

}  // namespace

ExplicitStepper::ExplicitStepper(Shell& shell, const StepperOptions& options, StepperStart start)
    : Stepper(shell, options, start),
      threads(options.threads),
      elastic_gradient(shell, forces, options.shell, threads),
      contact(shell, options.contact, start.contact, options.gravity, threads),
      elastic(forces.elastic()),
      step{0, options.step, options.step, shell.position, shell.velocity, {}},
      length(options.step),
      velocity(shell.velocity),
      acceleration(Positions::Zero(3, shell.position.cols())) {}

Vector3d ExplicitStepper::Forces::on(Index v) const {
    Vector3d all = elastic.col(v) + contact.force.col(v);
    if (damping.cols() > 0) all += damping.col(v);
    if (opening.cols() > 0) all += opening.col(v);
    for (const Positions& one : outer) all += one.col(v);
    return all;
}

Positions ExplicitStepper::Forces::sum() const {
    Positions all(3, elastic.cols());
    for (Index v = 0; v < static_cast<Index>(all.cols()); ++v) all.col(v) = on(v);
    return all;
}

StepResult ExplicitStepper::begin(double of_step) try {
    open(of_step);
    return {};
} catch (const std::runtime_error& error) {
    return {Outcome::failed, error.what()};
}

void ExplicitStepper::open(double of_step) {
    discard();
    step = {time, of_step, of_step, shell.position, shell.velocity, {}};
    position = shell.position;
    velocity = shell.velocity;
    measure_vertices();
    contact.begin(time, first);
    if (first || made) {
        energies_now.reset();
        place_clamps_at_start(step);
    }
    for (Energy* energy : forces.loads()) energy->begin(step);
    ledger.begin(stored(), moving(velocity, position));
    work = {};
    inertia_work = 0;
    choose_substep();
    if (first || made) update_forces();
    first = made = false;
}

void ExplicitStepper::discard() {
    if (made) contact.of_bodies().restart();
}

void ExplicitStepper::choose_substep() {
    const Stopwatch watch(spent, Task::elasticity);
    const double strain = forces.face_strains(shell.position).cwiseAbs().maxCoeff();
    // The frequency is estimated after every crack: a face that a crack separates may have a far higher
    // frequency than with its neighbours.
    if (changed || strain > strain_at_estimate + growth) {
        shell_frequency = highest_frequency([this](const Positions& x) { return elastic_gradient.at(x); },
                                            shell, shell.position, mode);
        changed = false;
        strain_at_estimate = strain;
    }
    // Gravity is included: a sheet at rest that just touches another comes into contact within the step.
    Positions motion = step.length * shell.velocity;
    motion.colwise() += step.length * step.length * options.gravity;
    contact_frequency = resolution_of_contact * std::sqrt(contact.largest_rate(step, motion));
    const double highest = std::hypot(shell_frequency, contact_frequency);
    const double stable = stable_substep(highest, options.shell.damping, step.length);
    substeps = std::max(1, static_cast<int>(std::ceil(step.length / stable - 1e-9)));
    length = step.length / substeps;
}

void ExplicitStepper::visit_state(StateVisitor& visit) {
    static_assert(
        has_only<ExplicitStepper, Stepper, decltype(threads), decltype(elastic_gradient), decltype(contact),
                 decltype(opening), decltype(elastic), decltype(step), decltype(shell_frequency),
                 decltype(contact_frequency), decltype(substeps), decltype(length), decltype(first),
                 decltype(made), decltype(changed), decltype(strain_at_estimate), decltype(mode),
                 decltype(velocity), decltype(acceleration), decltype(forces_now), decltype(mass),
                 decltype(inverse_mass), decltype(gravity), decltype(guided), decltype(moved),
                 decltype(acceleration_before), decltype(forces_before), decltype(energies_now),
                 decltype(work), decltype(inertia_work)>());
    Stepper::visit_state(visit);
    if (visit.reads()) elastic_gradient.shell_changed();
    visit(contact, opening, step, shell_frequency, contact_frequency, substeps, length, first, made, changed,
          strain_at_estimate, mode, velocity, acceleration, forces_now, energies_now, work, inertia_work);
}

template <class Range>
void ExplicitStepper::share_vertices(const Range& range) const {
    threads.share_ranges(static_cast<Index>(position.cols()), vertices_at_once, range);
}

void ExplicitStepper::find_forces() {
    {
        const Stopwatch watch(spent, Task::elasticity);
        elastic_gradient.find(position);
    }
    forces_now.outer.resize(forces.outer().size());
    for (std::size_t i = 0; i < forces.outer().size(); ++i) {
        const Stopwatch watch(spent, Task::loads);
        const OuterEnergy& outer = forces.outer()[i];
        Positions& force = forces_now.outer[i];
        force.setZero(3, position.cols());
        outer.energy->add_gradient(
            outer.of_velocity ? Positions(step.origin + step.lag * velocity) : position, force);
        force *= -1;
    }
    forces_now.opening.setZero(3, opening.empty() ? 0 : position.cols());
    opening.add_forces(forces_now.opening);
    const Stopwatch watch(spent, Task::contact);
    contact.find_forces({length, position, velocity}, forces_now.contact);
}

void ExplicitStepper::update_forces() {
    find_forces();
    forces_now.elastic.resize(3, position.cols());
    forces_now.damping.setZero(3, options.shell.damping.stiffness > 0 ? position.cols() : 0);
    elastic_gradient.put_forces(0, static_cast<Index>(position.cols()), forces_now.elastic);
    accelerate();
}

void ExplicitStepper::accelerate(Index begin, Index end) {
    const auto some = [&](auto& all) { return range_of(all, begin, end); };
    auto accelerations = some(acceleration);
    accelerations = some(forces_now.elastic) + some(forces_now.contact.force);
    if (forces_now.damping.cols() > 0) accelerations += some(forces_now.damping);
    if (forces_now.opening.cols() > 0) accelerations += some(forces_now.opening);
    for (const Positions& one : forces_now.outer) accelerations += some(one);
    accelerations = accelerations * some(inverse_mass) + some(gravity);
    for (auto v = std::ranges::lower_bound(guided, begin); v != guided.end() && *v < end; ++v)
        acceleration.col(*v) = constrained(shell, *v, acceleration.col(*v));
}

void ExplicitStepper::measure_vertices() {
    const Eigen::Index count = shell.mass.size();
    mass = Vector3d::Ones() * shell.mass.transpose();
    inverse_mass = mass.cwiseInverse();
    gravity = options.gravity.replicate(1, count);
    guided.clear();
    for (Index v = 0; v < static_cast<Index>(count); ++v) {
        if (shell.fixed[v]) {
            inverse_mass.col(v).setZero();
            gravity.col(v).setZero();
        } else if (shell.guide[v] != 0) {
            guided.push_back(v);
        }
    }
}

StepResult ExplicitStepper::solve(int) try {
    const Stopwatch watch(spent, Task::other);  // time that no other stopwatch measures
    return {Outcome::done, {}, made ? 0 : make_open_step()};
} catch (const std::runtime_error& error) {
    return {Outcome::failed, error.what()};
}

int ExplicitStepper::make_open_step() {
    const OpeningEdges opening_then = opening;
    int made_substeps = make_step();
    while (!contact.end(step, position)) {
        opening = opening_then;
        made_substeps += make_step_again();
    }
    ledger.solved(stored());
    return made_substeps;
}

int ExplicitStepper::make_step_again() {
    ledger.scheme_changed();  // contact springs under load may have another stiffness now
    try {
        open(step.length);
        if (substeps > most_again) ExplicitContact::refuse_passage();
        return make_step();
    } catch (const std::runtime_error&) {  // too many substeps: the impact, the cause, is reported
        ExplicitContact::refuse_passage();
    }
}

int ExplicitStepper::make_step() {
    made = true;
    for (int i = 0; i < substeps; ++i) make_substep(step.begin + step.length * i / substeps);
    energies_now.reset();
    const VectorXd mass = free_mass(shell);
    work.balance.lost_to_scheme =
        inertia_work - kinetic_energy(mass, velocity) + kinetic_energy(mass, shell.velocity);
    ledger.moves(moving(velocity, position));
    require_stable(position.allFinite());
    return substeps;
}

PotentialEnergies ExplicitStepper::elastic_energies() const {
    if (!energies_now) energies_now = Stepper::elastic_energies();
    return *energies_now;
}

void ExplicitStepper::move(double end) {
    moved.resize(3, position.cols());
    share_vertices([&](Index begin, Index end_of_range) {
        const auto some = [&](auto& all) { return range_of(all, begin, end_of_range); };
        some(velocity) += length / 2 * some(acceleration);
        some(moved) = some(position);
        some(position) += length * some(velocity);
        some(moved) = some(position) - some(moved);
    });
    if (!shell.motions.empty()) move_scripted(end);
}

void ExplicitStepper::move_scripted(double end) {
    const Positions drifted = position;
    place_scripted(shell, end, position);
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0) {
            moved.col(v) += position.col(v) - drifted.col(v);
            const Vector3d now = moved.col(v) / length;
            const double change = 0.5 * shell.mass[v] * (now.squaredNorm() - velocity.col(v).squaredNorm());
            work.balance.work_of_supports += change - shell.mass[v] * options.gravity.dot(moved.col(v));
            velocity.col(v) = now;
        }
}

void ExplicitStepper::make_substep(double from) {
    StepContext substep;
    substep.begin = from;
    substep.length = length;
    contact.of_bodies().kick(length);
    move(substep.end());
    contact.of_bodies().drift(length);
    contact.place(from, substep.end());
    if (forces.mirrors_move())
        for (Energy* energy : elastic) energy->begin(substep);
    opening.fade(moved, length);
    std::swap(forces_before, forces_now);
    std::swap(acceleration_before, acceleration);
    find_forces();
    const Work of_substep = kick();
    contact.of_bodies().kick(length);
    const double of_mirrors = forces.mirror_work(substep, position);
    work.balance.work_of_supports += of_mirrors;
    work.against_stored += of_mirrors;
    enter(of_substep);
}

ExplicitStepper::Work ExplicitStepper::kick() {
    const double damping = options.shell.damping.stiffness;
    forces_now.elastic.resize(3, position.cols());
    forces_now.damping.resize(3, damping > 0 ? position.cols() : 0);
    acceleration.resize(3, position.cols());
    std::vector<Work> of_ranges((position.cols() + vertices_at_once - 1) / vertices_at_once);
    share_vertices([&](Index begin, Index end) {
        const auto some = [&](auto& all) { return range_of(all, begin, end); };
        elastic_gradient.put_forces(begin, end, forces_now.elastic);
        const auto elastic_then = some(forces_before.elastic), elastic_now = some(forces_now.elastic);
        if (damping > 0) some(forces_now.damping) = damping / length * (elastic_now - elastic_then);
        accelerate(begin, end);
        some(velocity) += length / 2 * some(acceleration);
        const ContactForces &then = forces_before.contact, &now = forces_now.contact;
        of_ranges[begin / vertices_at_once] = {
            -0.5 * ((elastic_then + elastic_now + some(then.force) + some(now.force)) * some(moved)).sum(),
            0.5 * (some(mass) * (some(acceleration_before) + some(acceleration)) * some(moved)).sum(),
            -0.5 * ((some(then.friction) + some(now.friction)) * some(moved)).sum()};
    });
    Work all;
    for (const Work& of_range : of_ranges) {
        all.of_inertia += of_range.of_inertia;
        all.against_stored += of_range.against_stored;
        all.lost_to_friction += of_range.lost_to_friction;
    }
    return all;
}

double ExplicitStepper::taken(const Positions& before, const Positions& now) const {
    double sum = 0;
    for (const Positions* forces_of : {&before, &now})
        if (forces_of->cols() > 0) sum -= 0.5 * forces_of->cwiseProduct(moved).sum();
    return sum;
}

void ExplicitStepper::enter(const Work& of_substep) {
    EnergyBalance& balance = work.balance;
    const Forces& before = forces_before;
    balance.lost_to_damping += taken(before.damping, forces_now.damping);
    balance.lost_to_cracks += taken(before.opening, forces_now.opening);
    for (std::size_t i = 0; i < before.outer.size(); ++i)
        balance.take(forces.outer()[i].part, taken(before.outer[i], forces_now.outer[i]));
    const ContactForces &then = before.contact, &now = forces_now.contact;
    const double of_obstacles =
        contact.obstacle_work(means(then.obstacles, now.obstacles), 0.5 * (then.deforming + now.deforming));
    const double of_friction =
        of_substep.lost_to_friction +
        contact.obstacle_work(means(then.obstacle_friction, now.obstacle_friction),
                              0.5 * (then.deforming_friction + now.deforming_friction));
    balance.work_of_obstacles += of_obstacles;
    balance.lost_to_friction += of_friction;
    work.against_stored += of_substep.against_stored + of_obstacles - of_friction;
    inertia_work += of_substep.of_inertia;
    if (shell.motions.empty()) return;
    // Supports with a prescribed motion work against all forces on their vertices.
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0)
            balance.work_of_supports -= 0.5 * (before.on(v) + forces_now.on(v)).dot(moved.col(v));
}

void ExplicitStepper::topology_changed(const ShellChange& change) {
    follow_in_motion(shell, change, position, velocity);
    if (mode.cols() > 0) follow(mode, change);
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
    for (Energy* energy : elastic) energy->topology_changed(change, step);
    for (Energy* energy : forces.loads()) energy->topology_changed(change, step);
    contact.shell_changed(change);
    elastic_gradient.shell_changed();
    changed = true;
    energies_now.reset();
    append(acceleration, change.vertices);
    measure_vertices();
    const Positions before = acceleration;
    update_forces();
    const double gone = ledger.topology_changed(stored(), moving(velocity, position), change.remeshes());
    if (!change.opening) return;
    opening.open(*change.opening, balancing_forces(before), position, gone);
    forces_now.opening.setZero(3, position.cols());
    opening.add_forces(forces_now.opening);
    accelerate();
}

Positions ExplicitStepper::balancing_forces(const Positions& before) const {
    Positions kept = (before - acceleration) * shell.mass.asDiagonal();
    constrain(shell, kept);
    return kept;
}

StepWork ExplicitStepper::all_work() const {
    const ExplicitBodies& bodies = contact.of_bodies();
    StepWork all = work;
    all.against_stored -= bodies.contact_work() - bodies.friction_work();
    all.balance.lost_to_friction -= bodies.friction_work();
    all.balance.lost_to_scheme += bodies.work_of_all() - bodies.kinetic_change();
    return all;
}

void ExplicitStepper::finish() {
    ledger.finish(all_work(), stored(), moving(velocity, position));
    shell.position = position;
    shell.velocity = velocity;
    time = step.end();
    made = false;
}

std::vector<Reaction> ExplicitStepper::reactions() const {
    std::vector<Reaction> all(options.supports);
    if (options.supports > 0) {
        // Reactions are the blocked forces. Mass times acceleration, zero unless a support moves, is left
        // out.
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
