// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/simulation.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/contact/colliders/start_depth.h"
#include "core/shell/mean_edge_length.h"
#include "core/shell/position_spacing.h"
#include "fracture/step/load_locks.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Limit on the iterations between two stages. Few suffice: the next failures depend on the strains near the
/// edges that have just failed.
constexpr int iterations_between_stages = 10;
constexpr double no_freedom = 1e-9;  // entries of a projection below this are round-off

/// Returns Snapshot::edge_cohesive_share, [E].
std::vector<double> cohesive_shares(std::span<const EdgeState> states, const Stepper& stepper) {
    std::vector<double> shares(states.size(), 0);
    bool any = false;
    for (std::size_t e = 0; e < states.size(); ++e) {
        if (states[e] == EdgeState::interior) continue;
        shares[e] = stepper.cohesive_share(static_cast<Index>(e));
        any |= shares[e] > 0;
    }
    return any ? shares : std::vector<double>();
}

StepperOptions stepper_options(const SimulationOptions& options, const Shell& shell) {
    StepperOptions result = options.stepper;
    result.tolerance = options.tolerance * mean_edge_length(shell);
    return result;
}

/// Energy that all sheets and bodies gain by falling a tenth of a thickness, J: a bounce of no more energy is
/// no impact.
double little_fall(const Shell& shell, const StepperOptions& options) {
    double moment = shell.mass.dot(shell.thickness);
    for (const RigidBody& body : options.contact.bodies) moment += body.mass * shell.thickness.mean();
    return 0.1 * options.gravity.norm() * moment;
}

/// Returns the number of `one` in the list `all`, from 1. Appends `one` if it is not in the list.
template <class T>
std::size_t number_in(std::vector<T>& all, const T& one) {
    const auto number = static_cast<std::size_t>(std::find(all.begin(), all.end(), one) - all.begin());
    if (number == all.size()) all.push_back(one);
    return number + 1;
}

/// Returns the sheets with their held vertices fixed or guided.
BreakableShell supported(BreakableShell sheets, const std::vector<SupportedVertex>& supported_vertices) {
    Shell& shell = sheets.mechanics();
    for (const auto& [vertex, by] : supported_vertices) {
        shell.support_set[vertex] = static_cast<Index>(number_in(shell.support_sets, by));
        Matrix3d freedom = Matrix3d::Identity();
        for (const SupportDirections& hold : by) freedom -= hold.directions;
        if (freedom.isZero(no_freedom)) {
            shell.fixed[vertex] = 1;
            shell.velocity.col(vertex).setZero();
        } else {
            shell.guide[vertex] = static_cast<char>(number_in(shell.guides, freedom));
            shell.velocity.col(vertex) = freedom * shell.velocity.col(vertex).eval();
        }
    }
    return sheets;
}

/// Returns the sheets with their supports, and with the geometry of loads protected from changes of the mesh.
BreakableShell prepared(BreakableShell sheets, const SimulationOptions& options) {
    sheets = supported(std::move(sheets), options.supported_vertices);
    lock_load_geometry(sheets, options.stepper.shell);
    return sheets;
}

double largest(const VectorXd& measures) {
    return measures.size() == 0 ? 0 : measures.maxCoeff();
}

}  // namespace

Simulation::Simulation(BreakableShell sheets, const SimulationOptions& options)
    : options(options),
      breakable(prepared(std::move(sheets), options)),
      breaker(breakable, options),
      policy(options, little_fall(breakable.mechanics(), options.stepper)),
      taken(policy.choice()),
      obstacles_touched(options.stepper.contact.obstacles.size(), 0),
      bodies_touched(options.stepper.contact.bodies.size(), 0),
      scripts(breakable.mechanics().motions.size()) {
    release_apart(options.stepper.contact.bodies);
    stepper = make_stepper(breakable.mechanics(), stepper_options(options, breakable.mechanics()));
}

StepReport Simulation::step() try {
    StepReport report;
    report.step = ++steps;
    policy.begin_step();
    double time_left = 0;
    for (;;) {
        Attempt attempt{stepper->begin(policy.size())};                        // predicts, up to contact
        if (attempt) attempt.result = stepper->solve(options.max_iterations);  // balances all forces
        attempt.urgency = policy.urgency(attempt.result);
        report.newton_iterations += attempt.result.iterations;
        if (attempt) {
            const Stopwatch watch(stepper->time_spent(), Task::breaking);
            breakable.hold_back(time() + policy.size());
            const Measured now = breaker.measured(*stepper);  // strains and measures of hinges
            attempt.urgency = evaluate(now, report);          // checks whether another attempt is needed
            const bool staged = options.rule == BreakingRule::staged && !ends_at_crack;
            if (attempt && staged) attempt = break_in_stages(now, report);  // breaks, solves again
            if (attempt && !staged) break_at_once(now, report);
            if (attempt && policy.chooses_explicit_length() && report.stages == 0)
                time_left = breaker.time_left(now.hinges, time() + policy.size());
        }
        if (attempt) break;
        if (!policy.retry(attempt, report)) throw Error(failure(attempt), Fault::run);
        take_scheme();
    }
    report.step_size = policy.size();
    stepper->finish();
    policy.advance();
    report_state(report);  // reports energies and peaks
    enable_contact();      // re-enables contact
    policy.finish_step({report.peak_overload, report.stages > 0, report.contact, 0,
                        report.kinetic + report.bending + report.membrane + report.contact, time_left});
    take_scheme();
    return report;
} catch (const Error&) {
    throw;
} catch (const std::runtime_error& error) {
    // The mechanics report errors without step and time, which are added here.
    throw Error(where() + error.what(), Fault::run);
}

Urgency Simulation::evaluate(const Measured& now, StepReport& report) {
    ends_at_crack = options.until_crack && breaker.fails(now, this_stage(report), *stepper);
    if (ends_at_crack && policy.can_halve()) {
        ends_at_crack = false;
        return Urgency::unsolved;
    }
    report.peak_strain = largest(now.hinges.strain);
    report.peak_stress = largest(now.hinges.stress);
    report.peak_bending_strain = largest(now.hinges.bending);
    report.peak_overload = largest_overload(breakable, now.hinges, options.rule == BreakingRule::staged);
    const YieldPeak yielding = yield_peak(breakable, now.strains);
    report.peak_yield = yielding.ratio;
    report.yielding = yielding.place;
    const Urgency urgency = urgency_after(now, report);
    if (urgency == Urgency::none) breaker.record_measures(now.hinges);
    return urgency;
}

Urgency Simulation::urgency_after(const Measured& now, const StepReport& report) {
    if (!policy.can_switch_to_explicit()) return Urgency::none;
    const PotentialEnergies stored = stepper->energies();
    StepActivity solved{report.peak_overload, breaker.fails(now, this_stage(report), *stepper),
                        stored.contact, stepper->dissipated_by_scheme(),
                        kinetic_energy(breakable.mechanics()) + stored.stored()};
    for (const RigidBody& body : bodies()) solved.energy += body.kinetic_energy();
    return policy.urgency_of(solved);
}

Attempt Simulation::break_in_stages(Measured now, StepReport& report) {
    StepResult result;
    double waited = policy.size();
    bool is_cut_short = false;  // whether the last solution ended at its limit of iterations
    for (;;) {
        const bool may_break = report.stages < options.max_stages;
        const auto stage = breaker.break_stage(now, this_stage(report, waited), may_break, *stepper);
        const bool broken = stage == StageOutcome::broken;
        report.stage_cap_reached = stage == StageOutcome::capped;
        report.stages += broken;
        if (broken ? !stepper->solves_again() : !is_cut_short) break;
        result = stepper->solve(broken ? iterations_between_stages : options.max_iterations);
        report.newton_iterations += result.iterations;
        if (broken && result.outcome == Outcome::passage) break;
        is_cut_short = broken && result.limited;
        waited = 0;
        now = breaker.measured(*stepper);
    }
    report.reactions = stepper->reactions();
    return {result, result.outcome == Outcome::passage ? Urgency::passage : Urgency::none};
}

void Simulation::break_at_once(const Measured& now, StepReport& report) {
    // By the paper's rule, hinges break after the solution. The reactions are in balance before they break.
    report.reactions = stepper->reactions();
    report.stages += breaker.break_at_once(now, this_stage(report), *stepper);
}

void Simulation::take_scheme() {
    if (policy.choice() == taken) return;
    taken = policy.choice();
    stepper = with_scheme(std::move(stepper), taken.scheme, taken.barriers_follow);
}

std::string Simulation::where() const {
    const bool statics = is_static();
    std::ostringstream text;
    text << "step " << steps << ", at " << (statics ? "load " : "") << time() << (statics ? ": " : " s: ");
    return text.str();
}

std::string Simulation::failure(const Attempt& last) const {
    const bool statics = is_static();
    const char* unit = statics ? "" : " s";
    std::ostringstream text;
    text << where();
    if (last.result.outcome == Outcome::failed) {
        text << last.result.why;
        if (last.urgency == Urgency::explicit_failed && options.alternates)
            text << "; and implicit steps from there cannot be solved, either";
        return text.str();
    }
    if (last.urgency == Urgency::passage) {
        text << "even in a step of " << policy.size() << unit
             << " surfaces pass through each other; a thicker or stiffer sheet, less speed, or a finer mesh "
                "may help";
        return text.str();
    }
    text << "even a step of " << policy.size() << unit << " cannot be solved within "
         << options.max_iterations << " iterations; ";
    const double farthest = breakable.mechanics().position.cwiseAbs().maxCoeff();
    if (const double spacing = position_spacing(farthest);
        spacing > coarsest_spacing * mean_edge_length(breakable.mechanics()))
        text << "it lies " << farthest << " m from the origin, where positions are rounded to " << spacing
             << " m: place the scene near the origin";
    else
        text << "more iterations (solver.max_iterations) or a larger solver.tolerance may help, and sherd "
                "check warns of implausible numbers";
    if (statics)
        text << "; or there is no equilibrium nearby: the shell snaps through (solver.arc_length = true "
                "follows it), a piece has come off, or a sheet can rotate or slide as a whole";
    const bool obstacle_moves = std::ranges::any_of(options.stepper.contact.obstacles, &Obstacle::moves);
    if (obstacle_moves || !breakable.mechanics().motions.empty())
        text << "; or a moving pin or obstacle pushes against something that cannot move away";
    if (!options.stepper.contact.bodies.empty())
        text << "; or a free obstacle moves so fast that it would pass through what it meets";
    return text.str();
}

bool Simulation::release_apart(const std::vector<RigidBody>& bodies) {
    const ContactOptions& contact = options.stepper.contact;
    const bool of_sheets = contact.sheets && breakable.release_apart();
    const bool of_colliders = shrink_start_depths(breakable.mechanics(), contact.obstacles, bodies, time());
    return of_sheets || of_colliders;
}

void Simulation::enable_contact() {
    // Must precede take_scheme(): a stepper of another scheme has no contacts before it begins a step.
    const Stopwatch watch(stepper->time_spent(), Task::contact);
    if (release_apart(bodies())) stepper->topology_changed({});
}

void Simulation::report_state(StepReport& report) {
    report.time = time();
    report.load = stepper->load();
    {
        const Stopwatch watch(stepper->time_spent(), Task::breaking);
        breaker.finish_step(steps, time(), report.stages > 0);
    }
    report_energies(report);
    report_touch(report);
    report_gauges(report);
    report.crack_face_overlap = stepper->crack_face_overlap();
    report.exempt_pairs = static_cast<Index>(breakable.exempt_pairs());
    report.fragments = breaker.fragments().count();
    report.is_explicit = policy.is_explicit();
    if (const auto face = stepper->fastest_triangle())
        report.fastest = face_place(breakable.mechanics(), *face);
}

void Simulation::report_energies(StepReport& report) const {
    const PotentialEnergies potential = stepper->energies();
    report.kinetic = kinetic_energy(breakable.mechanics());
    report.bending = potential.bending;
    report.membrane = potential.membrane;
    report.gravity = potential.gravity;
    report.contact = potential.contact;
    report.residual = breaker.residual();
    static_cast<EnergyBalance&>(report) = stepper->balance();
    report.lost_to_cracks += breaker.residual_taken();
    report.linear_momentum = linear_momentum(breakable.mechanics());
    report.angular_momentum = angular_momentum(breakable.mechanics());
    for (const RigidBody& body : bodies()) {
        report.kinetic += body.kinetic_energy();
        report.linear_momentum += body.mass * body.velocity;
        report.angular_momentum += body.mass * body.centre.cross(body.velocity) + body.angular_momentum;
    }
}

void Simulation::report_touch(StepReport& report) {
    const Touch touch = stepper->touch();
    report.contacts = static_cast<Index>(touch.vertices.size());
    report.obstacle_overlap = touch.deepest;
    for (const std::size_t obstacle : touch.obstacles) obstacles_touched[obstacle] = 1;
    for (const std::size_t body : touch.bodies) bodies_touched[body] = 1;
}

void Simulation::report_gauges(StepReport& report) const {
    const Shell& shell = breakable.mechanics();
    Eigen::Matrix3Xd strains, curvatures;
    if (std::ranges::any_of(gauges(), [](const Gauge& gauge) { return gauge.fields.any(); })) {
        strains = stepper->face_strains();
        curvatures = stepper->face_curvatures();
    }
    for (const Gauge& gauge : gauges()) {
        std::optional<FaceState> state;
        if (gauge.fields.any())
            state = face_state(shell, gauge.face, strains.col(gauge.face), curvatures.col(gauge.face));
        report.gauges.push_back(reading(shell, gauge, state));
    }
}

void Simulation::break_by_hand(std::span<const Edge> edges) {
    require_hinges(breakable, edges);
    const std::vector<HingeMeasure> measures = breaker.measured(edges, *stepper);
    // A change of the shell needs an open step. The next begin() discards this step, and enters the energy
    // that is lost in the balance.
    if (const StepResult begun = stepper->begin(policy.size()); begun.outcome == Outcome::failed)
        throw Error(where() + begun.why, Fault::run);
    breaker.break_given(edges, measures, {steps, time(), time(), 0, 0}, *stepper);
    stepper->position = breakable.mechanics().position;
    breaker.finish_given(steps, time());
}

void Simulation::visit_state(StateVisitor& visit) {
    auto& [options, steps, breakable, breaker, policy, stepper, taken, obstacles_touched, bodies_touched,
           ends_at_crack, scripts] = *this;
    visit(policy);
    take_scheme();  // the restored state belongs to the scheme of the stepper that wrote it
    visit(steps, breakable, stepper, breaker, obstacles_touched, bodies_touched, ends_at_crack);
}

Snapshot Simulation::snapshot(const FaceFieldChoice& fields) const {
    Snapshot snapshot = take_snapshot(breakable, breaker.fragments().of_face());
    snapshot.step = steps;
    snapshot.time = time();
    snapshot.edge_cohesive_share = cohesive_shares(snapshot.edge_state, *stepper);
    if (fields.any())
        snapshot.fields =
            face_fields(breakable.mechanics(), stepper->face_strains(), stepper->face_curvatures(), fields);
    return snapshot;
}

}  // namespace sherd
