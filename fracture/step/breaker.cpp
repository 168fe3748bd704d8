// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/breaker.h"

#include <algorithm>
#include <array>

#include "fracture/cracks/residual_stress.h"
#include "fracture/cracks/small_pieces.h"

namespace sherd {
namespace {

/// Degrees: smallest angle of the triangles that cracks leave, where that is possible. Narrow triangles
/// vibrate fast, and make the substeps of explicit steps short.
constexpr double wanted_angle = 28;

/// Energy of residual stress, J, that is released if these edges fail one after the other.
double residual_released(const BreakableShell& shell, std::span<const Edge> edges) {
    std::vector<CrackPiece> pieces;
    double released = 0;
    for (const Edge edge : edges) {
        const Vertex first = shell.mesh().vertex(edge, 0), second = shell.mesh().vertex(edge, 1);
        const Positions& rest = shell.mechanics().rest;
        const CrackPiece piece{rest.col(static_cast<Index>(first)), rest.col(static_cast<Index>(second))};
        released += residual_release(shell, first, piece.to, pieces) * (piece.to - piece.from).norm();
        pieces.push_back(piece);
    }
    return released;
}

std::vector<HingeMeasure> measures_of(const BreakableShell& shell, std::span<const Edge> edges,
                                      const HingeMeasures& all) {
    std::vector<HingeMeasure> measures;
    for (const Edge edge : edges) measures.push_back(all.at(shell.hinge_of_edge(edge)));
    return measures;
}

std::array<Index, 2> ends_of(const Mesh& mesh, Edge edge) {
    return {static_cast<Index>(mesh.vertex(edge, 0)), static_cast<Index>(mesh.vertex(edge, 1))};
}

}  // namespace

Breaker::Breaker(BreakableShell& sheets, const SimulationOptions& options)
    : staged(options.rule == BreakingRule::staged),
      all_gauges(options.gauges),
      residual_at_start(residual_energy(sheets, options.cracks)),
      residual_now(residual_at_start),
      shell(with_cracks(sheets, options.cracks)),
      growth(shell, options.stepper.shell.membrane, options.stepper.scheme == Scheme::statics),
      pieces(shell.mesh(), shell.face_areas()) {}

BreakableShell& Breaker::with_cracks(BreakableShell& sheets, std::span<const Edge> cracks) {
    if (cracks.empty()) return sheets;
    for (const Edge edge : cracks) {
        EdgeFailure failure;
        failure.edge = static_cast<Index>(edge);
        failure.vertices = ends_of(sheets.mesh(), edge);
        events.failures.push_back(failure);
    }
    const BreakableShell::Change change = sheets.fail(cracks);
    record_change(change.cracks, 0);
    follow(sheets.mechanics(), change.shell, all_gauges);
    return sheets;
}

Measured Breaker::measured(const Stepper& stepper) const {
    Measured now;
    now.strains.membrane = stepper.face_strains();
    const std::optional<Eigen::Matrix3Xd> coupled = stepper.coupled_curvatures();
    if (growth.needed() || shell.yields())
        now.strains.curvature = coupled ? *coupled : stepper.face_curvatures();
    now.hinges =
        hinge_measures(shell, stepper.position, coupled, now.strains.membrane, stepper.plastic_curvatures());
    return now;
}

std::vector<HingeMeasure> Breaker::measured(std::span<const Edge> edges, const Stepper& stepper) const {
    std::vector<HingeMeasure> measures;
    for (const Edge edge : edges) {
        const Index hinge = shell.hinge_of_edge(edge);
        const std::array<Index, 2> faces = faces_of_hinge(shell, hinge);
        measures.push_back(hinge_measure(shell, hinge, stepper.position, stepper.coupled_curvatures(faces),
                                         stepper.face_strains(faces), stepper.plastic_curvatures(faces)));
    }
    return measures;
}

bool Breaker::fails(const Measured& now, const BreakingStage& stage, Stepper& stepper) {
    return !overloaded_edges(shell, now.hinges).empty() || !next_crack_steps(now, stage, stepper).empty();
}

std::vector<CrackStep> Breaker::next_crack_steps(const Measured& now, const BreakingStage& stage,
                                                 Stepper& stepper) {
    if (!growth.needed()) return {};
    CrackEvaluation evaluation{now.strains, now.hinges, stage.begin, stage.end, stage.waited, {}, {}};
    evaluation.is_opening = [&stepper](Index edge) { return stepper.cohesive_share(edge) > 0; };
    // Without an equilibrium, tips are evaluated by stress: in explicit steps, in which the energy of fast
    // plates oscillates too much, and with hinges that are not coupled, whose energy is not usable at tips.
    if (stepper.scheme() != Scheme::explicit_differences && stepper.coupled_bending() != nullptr &&
        !growth.tips().empty())
        evaluation.equilibrium = {stepper.position, stepper.elastic_gradient(), stepper.crack_face_forces(),
                                  stepper.coupled_bending()};
    return growth.next(evaluation);
}

std::vector<Edge> Breaker::allowed(std::vector<Edge> edges) {
    prevented += prevent_small_pieces(shell, edges);
    std::erase_if(edges, [this](Edge edge) { return !shell.can_fail(edge); });
    return edges;
}

double Breaker::time_left(const HingeMeasures& measures, double time) const {
    return bears_half(shell, measures, staged) ? 0 : growth.time_left(time);
}

StageOutcome Breaker::break_stage(const Measured& now, const BreakingStage& stage, bool may_break,
                                  Stepper& stepper) {
    const std::vector<Edge> edges = allowed(most_overloaded_edges(shell, now.hinges));
    const std::vector<CrackStep> cracks = next_crack_steps(now, stage, stepper);
    if (edges.empty() && cracks.empty()) return StageOutcome::unchanged;
    if (!may_break) return StageOutcome::capped;
    if (!edges.empty()) fail(edges, measures_of(shell, edges, now.hinges), stage, stepper);
    const bool grows = grow(cracks, stage, stepper);
    return grows || !edges.empty() ? StageOutcome::broken : StageOutcome::unchanged;
}

Index Breaker::break_at_once(const Measured& now, BreakingStage stage, Stepper& stepper) {
    const Index first = stage.number;
    const std::vector<CrackStep> cracks = next_crack_steps(now, stage, stepper);
    if (const std::vector<Edge> edges = overloaded_edges(shell, now.hinges); !edges.empty()) {
        fail(edges, measures_of(shell, edges, now.hinges), stage, stepper);
        ++stage.number;
    }
    if (grow(cracks, stage, stepper)) ++stage.number;
    return stage.number - first;
}

void Breaker::break_given(std::span<const Edge> edges, std::span<const HingeMeasure> measures,
                          const BreakingStage& stage, Stepper& stepper) {
    residual_now -= residual_released(shell, edges);
    fail(edges, measures, stage, stepper);
}

void Breaker::fail(std::span<const Edge> edges, std::span<const HingeMeasure> measures,
                   const BreakingStage& stage, Stepper& stepper, const std::optional<Opening>& opening) {
    record_failures(edges, measures, stage);
    BreakableShell::Change change = shell.fail(edges);
    change.shell.opening = opening;
    follow_change(change, stage, stepper);
}

void Breaker::follow_change(const BreakableShell::Change& change, const BreakingStage& stage,
                            Stepper& stepper) {
    record_change(change.cracks, stage.step);
    follow(shell.mechanics(), change.shell, all_gauges);
    pieces.follow(change.cracks.topology);
    stepper.topology_changed(change.shell);
}

bool Breaker::grow(std::span<const CrackStep> crack_steps, const BreakingStage& stage, Stepper& stepper) {
    bool changed = false;
    std::vector<CrackStep> ready;
    for (CrackStep one : crack_steps) {
        if (!one.edge.is_valid()) {
            const auto made = make_edge(one, ready, stage, stepper);
            changed = changed || (made && made->way != AdvancedEdge::Way::existing);
            if (!made || !growth.take(*made, stage.begin, one)) continue;
        }
        if (std::ranges::find(ready, one.edge, &CrackStep::edge) == ready.end()) ready.push_back(one);
    }
    std::vector<CrackStep> gone;
    for (const CrackStep& one : ready) {
        if (allowed({one.edge}).empty()) continue;
        fail_by_toughness(one.edge, stage, stepper);
        gone.push_back(one);
    }
    grown += static_cast<Index>(gone.size());
    growth.done(gone, stage.end);
    return changed || !gone.empty();
}

std::optional<BreakableShell::Advanced> Breaker::make_edge(const CrackStep& crack_step,
                                                           std::span<const CrackStep> made_before,
                                                           const BreakingStage& stage, Stepper& stepper) {
    const Mesh& mesh = shell.mesh();
    AdvanceOptions options;
    options.snap_angle = options.wanted_angle = wanted_angle;
    options.kept.is_line = [&](Edge edge) {
        return std::ranges::find(made_before, edge, &CrackStep::edge) != made_before.end();
    };
    options.kept.is_fixed_vertex = [&](Vertex vertex) {
        return std::ranges::any_of(made_before, [&](const CrackStep& one) {
            return mesh.vertex(one.edge, 0) == vertex || mesh.vertex(one.edge, 1) == vertex;
        });
    };
    const Vertex tip(static_cast<unsigned>(crack_step.next.vertex));
    auto made = shell.advance(tip, crack_step.ray, options);
    if (made && made->way != AdvancedEdge::Way::existing) follow_change(made->change, stage, stepper);
    return made;
}

void Breaker::fail_by_toughness(Edge edge, const BreakingStage& stage, Stepper& stepper) {
    const double released = residual_released(shell, std::array{edge});
    residual_now -= released;
    fail(std::array{edge}, measured(std::array{edge}, stepper), stage, stepper, opening_of(edge, released));
}

std::optional<Opening> Breaker::opening_of(Edge edge, double available) const {
    const Shell& mechanics = shell.mechanics();
    const std::array<Index, 2> ends = ends_of(shell.mesh(), edge);
    const double length = (mechanics.rest.col(ends[0]) - mechanics.rest.col(ends[1])).norm();
    const Toughness& toughness = shell.toughness(edge);
    const double needed = toughness.value * toughness.value / mechanics.young[ends[0]] * length *
                          mean_thickness(mechanics, ends);
    if (available >= needed) return std::nullopt;
    return Opening{static_cast<Index>(edge), needed - available, length / toughness.speed_limit};
}

void Breaker::record_failures(std::span<const Edge> edges, std::span<const HingeMeasure> measures,
                              const BreakingStage& stage) {
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge edge = edges[i];
        EdgeFailure failure;
        failure.step = stage.step;
        failure.stage = stage.number;
        failure.edge = static_cast<Index>(edge);
        failure.vertices = ends_of(shell.mesh(), edge);
        failure.strain = measures[i].strain;
        failure.stress = measures[i].stress;
        failure.overload = overload(shell, measures[i], edge, staged);
        events.failures.push_back(failure);
    }
}

void Breaker::record_change(const CrackMesh::Change& change, std::int64_t step) {
    const std::size_t first = events.failures.size() - change.boundary_vertices.size();
    for (std::size_t i = 0; i < change.boundary_vertices.size(); ++i)
        events.failures[first + i].boundary_vertices = change.boundary_vertices[i];
    for (const auto& [edge, created] : change.topology.opened)
        events.openings.push_back({0, step, static_cast<Index>(edge), static_cast<Index>(created)});
    append_insertions(change.topology, step, events);
}

void Breaker::record_fragments(std::int64_t step) {
    const Index before = pieces.count();
    pieces.update(shell.mesh(), shell.face_areas());
    for (Index fragment = before; fragment < pieces.count(); ++fragment)
        events.fragment_splits.push_back({0, step, fragment, pieces.parents()[fragment]});
}

void Breaker::finish_given(std::int64_t step, double time) {
    record_fragments(step);
    set_time(events, step, time);
}

void Breaker::finish_step(std::int64_t step, double time, bool broken) {
    hinge_peaks.finish_step();
    if (broken) record_fragments(step);
    for (TipRecord& tip : growth.records(shell.mechanics().position, time)) {
        tip.step = step;
        events.tips.push_back(tip);
    }
    set_time(events, step, time);
}

}  // namespace sherd
