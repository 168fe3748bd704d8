// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/explicit_stepper.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/shell/patch_momentum.h"
#include "core/shell/supports.h"
#include "core/time/stable_substep.h"
#include "core/time/substep_levels.h"

namespace sherd {
namespace {

/// Contact that begins or ends within a part of a substep causes an error in energy that grows with the
/// square of length times frequency: parts with contact have a third of the stable length.
constexpr double resolution_of_contact = 3;
/// Number of substeps in place of each one while edges open: cohesive forces fade from substep to substep.
constexpr int substeps_of_opening = 2;
/// Shortest substeps with local steps, over the coefficient of stiffness-proportional damping.
constexpr double least_over_damping = 10;
/// Share of the stable substep that is taken. Bounds on frequencies are from above, but large motions stiffen
/// the sheet; rates of contact are those at the beginning of the step.
constexpr double safety_of_bounds = 0.9, safety_of_contact = 0.8;
/// Growth of the largest strain after which all bounds are computed again: the membrane's
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
      local_steps(shell, elastic_gradient),
      contact(shell, options.contact, start.contact, options.gravity, threads),
      elastic(forces.elastic()),
      step{0, options.step, options.step, shell.position, shell.velocity, {}},
      length(options.step),
      velocity(shell.velocity),
      acceleration(Positions::Zero(3, shell.position.cols())),
      contact_acceleration(acceleration) {}

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
    const bool stale = choose_substeps();
    if (first || made)
        update_forces();
    else if (stale)
        update_elastic_forces();
    else
        accelerate_in_contact();
    first = made = false;
}

void ExplicitStepper::discard() {
    if (made) contact.of_bodies().restart();
}

double ExplicitStepper::stable(double squared_frequency, double share) const {
    return stable_substep(std::sqrt(squared_frequency), options.shell.damping, step.length, share);
}

bool ExplicitStepper::choose_substeps() {
    bool levels_change = (update_bounds() || divided != step.length) && choose_levels();
    const double length_before = length;
    const ContactRates rates = look_ahead();
    if (local_steps.highest() > 0 && substeps_with(rates) > elastic_substeps) {
        allows_levels = false;
        levels_change = choose_levels();
    }
    substeps = substeps_with(rates);
    length = step.length / substeps;
    const double highest = std::max(rates.of_bodies, rates.of_vertices.maxCoeff());
    parts = substeps_of(length, stable(highest, safety_of_contact / resolution_of_contact));
    return levels_change || (length != length_before && local_steps.highest() > 0);
}

ContactRates ExplicitStepper::look_ahead() {
    const Stopwatch watch(spent, Task::contact);
    return contact.look_ahead(step);
}

int ExplicitStepper::substeps_with(const ContactRates& rates) const {
    double longest = step.length / elastic_substeps;
    // Elasticity acts on a vertex in contact only at the beginning and the end of a substep. So that this
    // excites no vibration of the contact, the substep must be stable for both together.
    for (const Index v : contact.vertices())
        longest = std::min(longest, stable(bounds.squares()[v] + rates.of_vertices[v], safety_of_bounds));
    return (opening.empty() ? 1 : substeps_of_opening) * substeps_of(step.length, longest);
}

bool ExplicitStepper::update_bounds() {
    const Stopwatch watch(spent, Task::elasticity);
    const double strain = forces.face_strains(shell.position).cwiseAbs().maxCoeff();
    // Bounds change with every crack: a face that a crack separates may have a far higher frequency than with
    // its neighbours.
    if (strain > strain_at_bounds + growth || bounds.squares().size() == 0) {
        bounds.find(elastic, shell, shell.position);
        strain_at_bounds = strain;
    } else if (changed) {
        bounds.follow(elastic, shell, shell.position);
    } else {
        return false;
    }
    changed = false;
    return true;
}

bool ExplicitStepper::choose_levels() {
    VectorXd longest = bounds.squares();
    for (double& of_vertex : longest) of_vertex = stable(of_vertex, safety_of_bounds);
    const LevelLimits limits{allows_levels && elastic_gradient.is_local(), LocalSteps::share_of_stable,
                             least_over_damping * options.shell.damping.stiffness};
    SubstepLevels chosen = substep_levels(shell, longest, step.length, limits);
    elastic_substeps = chosen.substeps;
    divided = step.length;
    return local_steps.set_levels(std::move(chosen.levels));
}

void ExplicitStepper::visit_state(StateVisitor& visit) {
    static_assert(
        has_only<ExplicitStepper, Stepper, decltype(threads), decltype(elastic_gradient),
                 decltype(local_steps), decltype(contact), decltype(opening), decltype(elastic),
                 decltype(step), decltype(bounds), decltype(strain_at_bounds), decltype(divided),
                 decltype(elastic_substeps), decltype(allows_levels), decltype(substeps), decltype(parts),
                 decltype(length), decltype(first), decltype(made), decltype(changed), decltype(velocity),
                 decltype(acceleration), decltype(contact_acceleration), decltype(forces_now),
                 decltype(contact_now), decltype(mass), decltype(inverse_mass), decltype(gravity),
                 decltype(guided), decltype(moved), decltype(moved_in_part), decltype(acceleration_before),
                 decltype(contact_acceleration_before), decltype(forces_before), decltype(contact_before),
                 decltype(energies_now), decltype(work), decltype(inertia_work)>());
    Stepper::visit_state(visit);
    visit(local_steps, contact, opening, step, bounds, strain_at_bounds, divided, elastic_substeps,
          allows_levels, substeps, parts, length, first, made, changed, velocity, acceleration, forces_now,
          contact_now, energies_now, work, inertia_work);
}

template <class Range>
void ExplicitStepper::share_vertices(const Range& range) const {
    threads.share_ranges(static_cast<Index>(position.cols()), vertices_at_once, range);
}

void ExplicitStepper::update_forces() {
    find_outer_forces();
    find_contact_forces(length / parts);
    forces_now.damping.setZero(3, options.shell.damping.stiffness > 0 ? position.cols() : 0);
    update_elastic_forces();
}

void ExplicitStepper::update_elastic_forces() {
    find_elastic_forces();
    accelerate();
    accelerate_in_contact();
}

void ExplicitStepper::find_outer_forces() {
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
}

void ExplicitStepper::find_elastic_forces() {
    const Stopwatch watch(spent, Task::elasticity);
    Positions others;
    if (local_steps.highest() > 0) {
        others = options.gravity * shell.mass.transpose() + contact_now.force;
        if (forces_now.opening.cols() > 0) others += forces_now.opening;
        for (const Positions& one : forces_now.outer) others += one;
    }
    local_steps.find(position, length, others, forces_now.elastic);
}

void ExplicitStepper::find_contact_forces(double length_of_part) {
    const Stopwatch watch(spent, Task::contact);
    contact.find_forces({length_of_part, position, velocity}, contact_now);
}

void ExplicitStepper::accelerate() {
    acceleration.resize(3, position.cols());
    share_vertices([&](Index begin, Index end) {
        const auto some = [&](auto& all) { return range_of(all, begin, end); };
        auto accelerations = some(acceleration);
        accelerations = some(forces_now.elastic);
        if (forces_now.damping.cols() > 0) accelerations += some(forces_now.damping);
        if (forces_now.opening.cols() > 0) accelerations += some(forces_now.opening);
        for (const Positions& one : forces_now.outer) accelerations += some(one);
        accelerations = accelerations * some(inverse_mass) + some(gravity);
        for (auto v = std::ranges::lower_bound(guided, begin); v != guided.end() && *v < end; ++v)
            acceleration.col(*v) = constrained(shell, *v, acceleration.col(*v));
    });
}

void ExplicitStepper::accelerate_in_contact() {
    contact_acceleration.resize(3, position.cols());
    for (const Index v : contact.vertices())
        contact_acceleration.col(v) =
            constrained(shell, v, contact_now.force.col(v).cwiseProduct(inverse_mass.col(v)));
}

Vector3d ExplicitStepper::Forces::on(Index v) const {
    Vector3d all = elastic.col(v);
    if (damping.cols() > 0) all += damping.col(v);
    if (opening.cols() > 0) all += opening.col(v);
    for (const Positions& one : outer) all += one.col(v);
    return all;
}

Positions ExplicitStepper::accelerations() const {
    Positions all = acceleration;
    for (const Index v : contact.vertices()) all.col(v) += contact_acceleration.col(v);
    return all;
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
    update_energies();  // after end(), which may have changed springs of contact
    ledger.solved(stored());
    return made_substeps;
}

int ExplicitStepper::make_step_again() {
    ledger.scheme_changed();  // contact springs under load may have another stiffness now
    try {
        open(step.length);
        if (substeps * parts > most_again) ExplicitContact::refuse_passage();
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
    return substeps * parts;
}

PotentialEnergies ExplicitStepper::elastic_energies() const {
    if (!energies_now) energies_now = Stepper::elastic_energies();
    return *energies_now;
}

void ExplicitStepper::update_energies() {
    energies_now.reset();
    if (const auto found = elastic_gradient.energies())
        energies_now = PotentialEnergies{found->bending, found->membrane, 0, stored_in_contact()};
}

void ExplicitStepper::make_substep(double from) {
    StepContext substep;
    substep.begin = from;
    substep.length = length;
    kick();
    moved = position;
    share_vertices([&](Index begin, Index end) {
        range_of(position, begin, end) += length * range_of(velocity, begin, end);
    });
    for (const Index v : contact.vertices()) position.col(v) = moved.col(v);
    for (int i = 0; i < parts; ++i) make_part(from + length * i / parts, length / parts);
    if (!shell.motions.empty()) place_scripted(shell, substep.end(), position);
    share_vertices([&](Index begin, Index end) {
        range_of(moved, begin, end) = range_of(position, begin, end) - range_of(moved, begin, end);
    });
    if (!shell.motions.empty()) follow_script(false, moved, length);
    if (forces.mirrors_move())
        for (Energy* energy : elastic) energy->begin(substep);
    opening.fade(moved, length);
    std::swap(forces_before, forces_now);
    std::swap(acceleration_before, acceleration);
    find_outer_forces();
    find_elastic_forces();
    forces_now.damping.resize(3, forces_before.damping.cols());
    if (forces_now.damping.cols() > 0)
        forces_now.damping =
            options.shell.damping.stiffness / length * (forces_now.elastic - forces_before.elastic);
    accelerate();
    kick();
    enter_work();
    const double of_mirrors = forces.mirror_work(substep, position);
    work.balance.work_of_supports += of_mirrors;
    work.against_stored += of_mirrors;
}

void ExplicitStepper::make_part(double from, double length_of_part) {
    kick_in_contact(length_of_part);
    contact.of_bodies().kick(length_of_part);
    moved_in_part.resize(3, position.cols());
    for (const Index v : contact.vertices()) moved_in_part.col(v) = position.col(v);
    for (const Index v : contact.vertices()) position.col(v) += length_of_part * velocity.col(v);
    if (!shell.motions.empty()) place_scripted(shell, from + length_of_part, position);
    for (const Index v : contact.vertices()) moved_in_part.col(v) = position.col(v) - moved_in_part.col(v);
    if (!shell.motions.empty()) follow_script(true, moved_in_part, length_of_part);
    contact.of_bodies().drift(length_of_part);
    contact.place(from, from + length_of_part);
    std::swap(contact_before, contact_now);
    std::swap(contact_acceleration_before, contact_acceleration);
    find_contact_forces(length_of_part);
    accelerate_in_contact();
    kick_in_contact(length_of_part);
    contact.of_bodies().kick(length_of_part);
    enter_contact_work();
}

void ExplicitStepper::kick() {
    share_vertices([&](Index begin, Index end) {
        range_of(velocity, begin, end) += length / 2 * range_of(acceleration, begin, end);
    });
}

void ExplicitStepper::kick_in_contact(double length_of_part) {
    for (const Index v : contact.vertices())
        velocity.col(v) += length_of_part / 2 * contact_acceleration.col(v);
}

void ExplicitStepper::follow_script(bool touching, const Positions& way, double duration) {
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0 && std::ranges::binary_search(contact.vertices(), v) == touching) {
            const Vector3d now = way.col(v) / duration;
            const double change = 0.5 * shell.mass[v] * (now.squaredNorm() - velocity.col(v).squaredNorm());
            work.balance.work_of_supports += change - shell.mass[v] * options.gravity.dot(way.col(v));
            velocity.col(v) = now;
        }
}

double ExplicitStepper::taken(const Positions& before, const Positions& now) const {
    double sum = 0;
    for (const Positions* forces_of : {&before, &now})
        if (forces_of->cols() > 0) sum -= 0.5 * forces_of->cwiseProduct(moved).sum();
    return sum;
}

void ExplicitStepper::enter_work() {
    struct Sums {
        double against_stored = 0, of_inertia = 0;
    };
    std::vector<Sums> of_ranges((position.cols() + vertices_at_once - 1) / vertices_at_once);
    share_vertices([&](Index begin, Index end) {
        const auto some = [&](auto& all) { return range_of(all, begin, end); };
        of_ranges[begin / vertices_at_once] = {
            -0.5 * ((some(forces_before.elastic) + some(forces_now.elastic)) * some(moved)).sum(),
            0.5 * (some(mass) * (some(acceleration_before) + some(acceleration)) * some(moved)).sum()};
    });
    for (const Sums& sums : of_ranges) {
        work.against_stored += sums.against_stored;
        inertia_work += sums.of_inertia;
    }
    EnergyBalance& balance = work.balance;
    balance.lost_to_damping += taken(forces_before.damping, forces_now.damping);
    balance.lost_to_cracks += taken(forces_before.opening, forces_now.opening);
    for (std::size_t i = 0; i < forces_now.outer.size(); ++i)
        balance.take(forces.outer()[i].part, taken(forces_before.outer[i], forces_now.outer[i]));
    if (shell.motions.empty()) return;
    // Supports with a prescribed motion work against all forces on their vertices.
    for (Index v = 0; v < static_cast<Index>(shell.script.size()); ++v)
        if (shell.script[v] != 0)
            balance.work_of_supports -= 0.5 * (forces_before.on(v) + forces_now.on(v)).dot(moved.col(v));
}

void ExplicitStepper::enter_contact_work() {
    EnergyBalance& balance = work.balance;
    const ContactForces &then = contact_before, &now = contact_now;
    double against_stored = 0, friction = 0;
    for (const Index v : contact.vertices()) {
        const Vector3d way = 0.5 * moved_in_part.col(v), force = then.force.col(v) + now.force.col(v);
        against_stored -= force.dot(way);
        friction -= (then.friction.col(v) + now.friction.col(v)).dot(way);
        inertia_work +=
            shell.mass[v] * (contact_acceleration_before.col(v) + contact_acceleration.col(v)).dot(way);
        if (shell.script[v] != 0) balance.work_of_supports -= force.dot(way);
    }
    const double of_obstacles =
        contact.obstacle_work(means(then.obstacles, now.obstacles), 0.5 * (then.deforming + now.deforming));
    const double of_friction =
        friction + contact.obstacle_work(means(then.obstacle_friction, now.obstacle_friction),
                                         0.5 * (then.deforming_friction + now.deforming_friction));
    balance.work_of_obstacles += of_obstacles;
    balance.lost_to_friction += of_friction;
    work.against_stored += against_stored + of_obstacles - of_friction;
}

void ExplicitStepper::topology_changed(const ShellChange& change) {
    // The forces before and after the change are compared: both without local steps, whose levels do not suit
    // the changed shell.
    if (local_steps.highest() > 0) {
        forces_now.elastic = local_steps.without_levels();
        accelerate();
    }
    local_steps.set_levels({});
    allows_levels = false;
    Positions before = accelerations();
    follow_in_motion(shell, change, position, velocity);
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
    for (Energy* energy : elastic) energy->topology_changed(change, step);
    for (Energy* energy : forces.loads()) energy->topology_changed(change, step);
    contact.shell_changed(change);
    elastic_gradient.shell_changed();
    changed = true;
    append(before, change.vertices);
    measure_vertices();
    update_forces();
    update_energies();
    const double gone = ledger.topology_changed(stored(), moving(velocity, position), change.remeshes());
    if (!change.opening) return;
    opening.open(*change.opening, balancing_forces(before), position, gone);
    forces_now.opening.setZero(3, position.cols());
    opening.add_forces(forces_now.opening);
    accelerate();
}

Positions ExplicitStepper::balancing_forces(const Positions& before) const {
    Positions kept = (before - accelerations()) * shell.mass.asDiagonal();
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
        Positions blocked(3, position.cols());
        for (Index v = 0; v < static_cast<Index>(position.cols()); ++v)
            blocked.col(v) = -forces_now.on(v) - contact_now.force.col(v);
        blocked -= options.gravity * shell.mass.transpose();
        Positions free = blocked;
        constrain(shell, free);
        add_reactions(shell, position, blocked - free, all);
        forces.add_mirror_reactions(position, all);
    }
    all.insert(all.end(), contact_now.obstacles.begin(), contact_now.obstacles.end());
    return all;
}

}  // namespace sherd
