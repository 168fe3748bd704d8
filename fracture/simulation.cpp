// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/simulation.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/contact/colliders/start_depth.h"
#include "core/shell/mean_edge_length.h"
#include "core/shell/position_spacing.h"
#include "fracture/hinge_measures.h"
#include "fracture/kept_loads.h"
#include "fracture/residual_stress.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Limit between two stages. Few iterations suffice: the next failures depend on the strains near the edges
/// that have just failed.
constexpr int iterations_between_stages = 10;
constexpr double no_freedom = 1e-9;  // projections below this are round-off

/// Returns Snapshot::edge_held, [E].
std::vector<double> held_shares(std::span<const EdgeState> states, const Stepper& stepper) {
    std::vector<double> shares(states.size(), 0);
    bool any = false;
    for (std::size_t e = 0; e < states.size(); ++e) {
        if (states[e] == EdgeState::interior) continue;
        shares[e] = stepper.held(static_cast<Index>(e));
        any |= shares[e] > 0;
    }
    return any ? shares : std::vector<double>();
}

StepperOptions stepper_options(const SimulationOptions& options, const Shell& shell) {
    StepperOptions result = options.stepper;
    result.tolerance = options.tolerance * mean_edge_length(shell);
    return result;
}

/// Energy that all sheets and bodies gain by falling a tenth of a thickness, J: bounces of no more energy are
/// no impacts.
double little_fall(const Shell& shell, const StepperOptions& options) {
    double moment = shell.mass.dot(shell.thickness);
    for (const RigidBody& body : options.contact.bodies) moment += body.mass * shell.thickness.mean();
    return 0.1 * options.gravity.norm() * moment;
}

/// The number of `one` in a list, from 1. It is appended when it is not there.
template <class T>
std::size_t number_in(std::vector<T>& all, const T& one) {
    const auto number = static_cast<std::size_t>(std::find(all.begin(), all.end(), one) - all.begin());
    if (number == all.size()) all.push_back(one);
    return number + 1;
}

/// Returns the sheets with their held vertices fixed or guided.
BreakableShell supported(BreakableShell sheets, const std::vector<HeldVertex>& held) {
    Shell& shell = sheets.mechanics();
    for (const auto& [vertex, by] : held) {
        shell.held[vertex] = static_cast<Index>(number_in(shell.holds, by));
        Matrix3d freedom = Matrix3d::Identity();
        for (const Hold& hold : by) freedom -= hold.directions;
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

double largest(const VectorXd& measures) {
    return measures.size() == 0 ? 0 : measures.maxCoeff();
}

}  // namespace

Simulation::Simulation(BreakableShell sheets, const SimulationOptions& options)
    : options(options),
      breakable(at_start(supported(std::move(sheets), options.held))),
      stepper(make_stepper(breakable.mechanics(), stepper_options(options, breakable.mechanics()))),
      growth(breakable, options.stepper.shell.membrane, options.stepper.scheme == Scheme::statics),
      fragments(breakable.mesh(), breakable.face_areas()),
      obstacles_touched(options.stepper.contact.obstacles.size(), 0),
      bodies_touched(options.stepper.contact.bodies.size(), 0),
      step_size(options.stepper.step),
      pace(little_fall(breakable.mechanics(), options.stepper)),
      scripts(breakable.mechanics().motions.size()) {}

BreakableShell Simulation::at_start(BreakableShell sheets) {
    keep_loads(sheets, options.stepper.shell);
    residual = residual_at_start = residual_energy(sheets, options.cracks);
    if (!options.cracks.empty()) open_cracks(sheets);
    release_apart(sheets, options.stepper.contact.bodies, 0);
    return sheets;
}

void Simulation::open_cracks(BreakableShell& sheets) {
    for (const Edge edge : options.cracks) {
        EdgeFailure failure;
        failure.edge = static_cast<Index>(edge);
        failure.vertices = {static_cast<Index>(sheets.mesh().vertex(edge, 0)),
                            static_cast<Index>(sheets.mesh().vertex(edge, 1))};
        events.failures.push_back(failure);
    }
    const BreakableShell::Change change = sheets.fail(options.cracks);
    record_change(change.cracks);
    follow(sheets.mechanics(), change.shell, options.gauges);
}

StepReport Simulation::step() try {
    StepReport report;
    report.step = ++steps;
    is_resort_tried = false;
    while (!attempt(report))
        if (!try_otherwise(report)) give_up(report);
    finish(report);
    return report;
} catch (const Error&) {
    throw;
} catch (const std::runtime_error& error) {
    // The mechanics report errors without step and time, which are added here.
    std::ostringstream text;
    text << "step " << steps << ", at " << (options.stepper.scheme == Scheme::statics ? "load " : "")
         << time() << (options.stepper.scheme == Scheme::statics ? ": " : " s: ") << error.what();
    throw Error(text.str(), Fault::run);
}

void Simulation::give_up(const StepReport& report) const {
    if (urgency == Urgency::overwhelmed)
        throw std::runtime_error(overwhelmed + "; and implicit steps from there cannot be solved, either");
    const bool statics = options.stepper.scheme == Scheme::statics;
    const char* unit = statics ? "" : " s";
    std::ostringstream text;
    text << "step " << report.step << ", at " << (statics ? "load " : "") << time() << unit << ": even ";
    if (urgency == Urgency::passage) {
        text << "in a step of " << step_size.size() << unit
             << " something passes through what it meets; a thicker or stiffer sheet, less speed, or a finer "
                "mesh may help";
        throw Error(text.str(), Fault::run);
    }
    text << "a step of " << step_size.size() << unit << " cannot be solved within " << options.max_iterations
         << " iterations; ";
    const double farthest = breakable.mechanics().position.cwiseAbs().maxCoeff();
    if (const double spacing = position_spacing(farthest);
        spacing > coarsest_spacing * mean_edge_length(breakable.mechanics()))
        text << "it lies " << farthest << " m from the origin, where positions have steps of " << spacing
             << " m: place the scene near the origin";
    else
        text << "more of them (solver.max_iterations) or a larger solver.tolerance may help, and sherd check "
                "warns of numbers that are hardly meant";
    if (statics)
        text
            << "; or there is no equilibrium near: the shell snaps through (solver.arc_length = true follows "
               "it), a piece came off, or a sheet can turn or glide as a whole";
    const bool obstacle_moves = std::ranges::any_of(options.stepper.contact.obstacles, &Obstacle::moves);
    if (obstacle_moves || !breakable.mechanics().motions.empty())
        text << "; or a moving pin or obstacle meets what cannot get out of its way";
    if (!options.stepper.contact.bodies.empty())
        text << "; or a free obstacle moves so fast that it would be beyond what it meets";
    throw Error(text.str(), Fault::run);
}

MinimiserResult Simulation::first_solution(StepReport& report) try {
    urgency = Urgency::unsolved;
    if (!stepper->begin(step_size.size())) return {};
    return solve_stage(report, options.max_iterations);
} catch (const Error&) {
    throw;
} catch (const std::runtime_error& error) {
    const bool is_explicit = stepper->scheme() == Scheme::explicit_differences;
    if (!options.alternates || !(is_explicit || pace.is_held())) throw;
    if (is_explicit) {
        urgency = Urgency::overwhelmed;
        overwhelmed = error.what();
    }
    return {};
}

bool Simulation::attempt(StepReport& report) {
    MinimiserResult newton = first_solution(report);
    if (!newton.converged) return false;
    const Stopwatch watch(stepper->time_spent(), Task::breaking);
    breakable.set_time(time() + step_size.size());
    const Measured now = measured();
    const HingeMeasures& measures = now.hinges;
    ends_at_crack = options.until_crack && fails(now);
    if (ends_at_crack && step_size.can_halve()) return ends_at_crack = false;
    report_peaks(report, now);
    urgency = judged(report, now);
    if (urgency != Urgency::none) return false;
    hinge_peaks.judge(breakable, measures);
    const bool in_stages = options.rule == BreakingRule::staged && !ends_at_crack;
    if (in_stages) newton = break_in_stages(report, newton, now);
    // By the paper's rule hinges break after the solution that balances the reactions.
    report.reactions = stepper->reactions();
    if (in_stages) return newton.converged;
    const std::vector<CrackStep> growing = next_crack_steps(now, 0);
    if (const std::vector<Edge> failing = overloaded_edges(breakable, measures); !failing.empty())
        break_edges(failing, measures, report.stages++);
    if (grow(growing, report.stages)) ++report.stages;
    return newton.converged;
}

MinimiserResult Simulation::break_in_stages(StepReport& report, MinimiserResult newton, Measured now) {
    double waited = step_size.size();
    bool is_cut_short = false;  // whether the last solution ended at its limit of iterations
    for (;;) {
        const std::vector<Edge> failing = allowed(most_overloaded_edges(breakable, now.hinges));
        const std::vector<CrackStep> growing = next_crack_steps(now, waited);
        waited = 0;
        const bool any = !failing.empty() || !growing.empty();
        report.stage_cap_reached = any && report.stages == options.max_stages;
        bool broken = false;
        if (any && !report.stage_cap_reached) {
            if (!failing.empty()) break_edges(failing, now.hinges, report.stages);
            broken = grow(growing, report.stages) || !failing.empty();
        }
        if (broken) {
            ++report.stages;
            if (!stepper->solves_again()) return newton;
            newton = solve_stage(report, iterations_between_stages);
            if (newton.passes) return newton;
            is_cut_short = newton.limited;
        } else if (is_cut_short) {
            newton = solve_stage(report, options.max_iterations);
            is_cut_short = false;
        } else {
            return newton;
        }
        now = measured();
    }
}

std::vector<CrackStep> Simulation::next_crack_steps(const Measured& now, double waited) {
    if (!growth.needed()) return {};
    Judged judged{now.strains, now.hinges, time(), time() + step_size.size(), waited, {}, {}};
    judged.is_opening = [this](Index edge) { return stepper->held(edge) > 0; };
    // In explicit steps, of fast plates, energy oscillates too much; hinges that are not coupled have no
    // usable energy.
    if (stepper->scheme() != Scheme::explicit_differences && stepper->coupled_bending() != nullptr &&
        !growth.tips().empty())
        judged.equilibrium = {stepper->position, stepper->elastic_gradient(), stepper->lip_forces(),
                              stepper->coupled_bending()};
    return growth.next(judged);
}

bool Simulation::fails(const Measured& now) {
    return !overloaded_edges(breakable, now.hinges).empty() || !next_crack_steps(now, 0).empty();
}

Simulation::Measured Simulation::measured() const {
    Measured now;
    now.strains.membrane = stepper->face_strains();
    const std::optional<Eigen::Matrix3Xd> coupled = stepper->coupled_curvatures();
    if (growth.needed() || breakable.yields())
        now.strains.curvature = coupled ? *coupled : stepper->face_curvatures();
    now.hinges = hinge_measures(breakable, stepper->position, coupled, now.strains.membrane,
                                stepper->kept_curvatures());
    return now;
}

MinimiserResult Simulation::solve_stage(StepReport& report, int max_iterations) {
    const MinimiserResult result = stepper->solve(max_iterations);
    report.newton_iterations += result.iterations;
    if (result.passes) urgency = Urgency::passage;
    return result;
}

void Simulation::update_fragments() {
    const Stopwatch watch(stepper->time_spent(), Task::breaking);
    const Index before = fragments.count();
    fragments.update(breakable.mesh(), breakable.face_areas());
    for (Index fragment = before; fragment < fragments.count(); ++fragment)
        events.births.push_back({0, steps, fragment, fragments.parents()[fragment]});
}

bool Simulation::release_apart(BreakableShell& sheets, const std::vector<RigidBody>& bodies,
                               double time) const {
    const ContactOptions& contact = options.stepper.contact;
    const bool of_sheets = contact.sheets && sheets.release_apart();
    const bool of_colliders = shrink_start_depths(sheets.mechanics(), contact.obstacles, bodies, time);
    return of_sheets || of_colliders;
}

void Simulation::report_peaks(StepReport& report, const Measured& measured) const {
    const HingeMeasures& measures = measured.hinges;
    report.peak_strain = largest(measures.strain);
    report.peak_stress = largest(measures.stress);
    report.peak_bending_strain = largest(measures.bending);
    report.peak_overload = largest_overload(breakable, measures, options.rule == BreakingRule::staged);
    const YieldPeak yielding = yield_peak(breakable, measured.strains);
    report.peak_yield = yielding.ratio;
    report.yielding = yielding.place;
}

void Simulation::finish(StepReport& report) {
    report.step_size = step_size.size();
    stepper->finish();
    hinge_peaks.finish_step();
    step_size.advance();
    report.time = time();
    report.load = stepper->load();
    if (report.stages > 0) update_fragments();
    for (TipRecord& tip : growth.records(breakable.mechanics().position, time())) {
        tip.step = steps;
        events.tips.push_back(tip);
    }
    set_time(events, steps, time());
    const PotentialEnergies potential = stepper->energies();
    report.kinetic = kinetic_energy(breakable.mechanics());
    report.bending = potential.bending;
    report.membrane = potential.membrane;
    report.gravity = potential.gravity;
    report.contact = potential.contact;
    report.residual = residual;
    static_cast<EnergyBalance&>(report) = stepper->balance();
    report.lost_to_cracks += residual_at_start - residual;
    report.linear_momentum = linear_momentum(breakable.mechanics());
    report.angular_momentum = angular_momentum(breakable.mechanics());
    for (const RigidBody& body : bodies()) {
        report.kinetic += body.kinetic_energy();
        report.linear_momentum += body.mass * body.velocity;
        report.angular_momentum += body.mass * body.centre.cross(body.velocity) + body.angular_momentum;
    }
    add_touch(report);
    read_gauges(report);
    report.lip_overlap = stepper->lip_overlap();
    report.exempt_pairs = static_cast<Index>(breakable.exempt_pairs());
    report.fragments = fragments.count();
    report.is_explicit = stepper->scheme() == Scheme::explicit_differences;
    if (const auto face = stepper->fastest_triangle())
        report.fastest = face_place(breakable.mechanics(), *face);
    {
        // Contacts are those of the stepper that made the step; one of another scheme has yet to begin.
        const Stopwatch watch(stepper->time_spent(), Task::contact);
        if (release_apart(breakable, bodies(), time())) stepper->topology_changed({});
    }
    pace_on(report);
}

void Simulation::add_touch(StepReport& report) {
    const Touch touch = stepper->touch();
    report.contacts = static_cast<Index>(touch.vertices.size());
    report.obstacle_overlap = touch.deepest;
    for (const std::size_t obstacle : touch.obstacles) obstacles_touched[obstacle] = 1;
    for (const std::size_t body : touch.bodies) bodies_touched[body] = 1;
}

void Simulation::read_gauges(StepReport& report) const {
    const Shell& shell = breakable.mechanics();
    Eigen::Matrix3Xd strains, curvatures;
    if (std::ranges::any_of(options.gauges, [](const Gauge& gauge) { return gauge.fields.any(); })) {
        strains = stepper->face_strains();
        curvatures = stepper->face_curvatures();
    }
    for (const Gauge& gauge : options.gauges) {
        std::optional<FaceState> state;
        if (gauge.fields.any())
            state = face_state(shell, gauge.face, strains.col(gauge.face), curvatures.col(gauge.face));
        report.gauges.push_back(reading(shell, gauge, state));
    }
}

void Simulation::visit_state(StateVisitor& visit) {
    auto& [options, steps, events, residual, residual_at_start, breakable, stepper, growth, fragments,
           hinge_peaks, obstacles_touched, bodies_touched, step_size, pace, urgency, overwhelmed,
           is_last_resort, is_resort_tried, ends_at_crack, forbidden, grown, scripts] = *this;
    // The restored state belongs to the scheme of the stepper that wrote it.
    Scheme scheme = stepper->scheme();
    const bool was_last_resort = is_last_resort;
    visit(scheme, is_last_resort);
    if (scheme != stepper->scheme() || is_last_resort != was_last_resort) change_scheme(scheme);
    visit(options.gauges, steps, events, residual, breakable, stepper, growth, fragments, hinge_peaks,
          obstacles_touched, bodies_touched, step_size, pace, ends_at_crack, forbidden, grown);
}

Snapshot Simulation::snapshot(const FaceFieldChoice& fields) const {
    Snapshot snapshot = take_snapshot(breakable, fragments.of_face());
    snapshot.step = steps;
    snapshot.time = time();
    snapshot.edge_held = held_shares(snapshot.edge_state, *stepper);
    if (fields.any())
        snapshot.fields =
            face_fields(breakable.mechanics(), stepper->face_strains(), stepper->face_curvatures(), fields);
    return snapshot;
}

CrackEvents Simulation::take_events() {
    return std::exchange(events, {});
}

}  // namespace sherd
