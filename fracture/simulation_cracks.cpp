// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "fracture/residual_stress.h"
#include "fracture/simulation.h"
#include "fracture/small_pieces.h"

// Failure of edges and propagation of cracks in a step; simulation.cpp has the step.

namespace sherd {
void Simulation::break_edges(std::span<const Edge> edges, const HingeMeasures& measures, Index stage,
                             const std::optional<Opening>& opening) {
    record_failures(edges, measures, stage);
    BreakableShell::Change change = breakable.fail(edges);
    change.shell.opening = opening;
    follow_change(change);
}

void Simulation::follow_change(const BreakableShell::Change& change) {
    record_change(change.cracks);
    follow(breakable.mechanics(), change.shell, options.gauges);
    fragments.follow(change.cracks.topology);
    stepper->topology_changed(change.shell);
}

std::vector<Edge> Simulation::allowed(std::vector<Edge> edges) {
    forbidden += keep_small_pieces_on(breakable, edges);
    std::erase_if(edges, [this](Edge edge) { return !breakable.can_fail(edge); });
    return edges;
}

std::optional<BreakableShell::Advanced> Simulation::make_edge(const CrackStep& crack_step,
                                                              std::span<const CrackStep> made_before) {
    const Mesh& mesh = breakable.mesh();
    AdvanceOptions options;
    options.kept.is_line = [&](Edge edge) {
        return std::ranges::find(made_before, edge, &CrackStep::edge) != made_before.end();
    };
    options.kept.keeps_place = [&](Vertex vertex) {
        return std::ranges::any_of(made_before, [&](const CrackStep& one) {
            return mesh.vertex(one.edge, 0) == vertex || mesh.vertex(one.edge, 1) == vertex;
        });
    };
    const Vertex tip(static_cast<unsigned>(crack_step.next.vertex));
    auto made = breakable.advance(tip, crack_step.ray, options);
    if (made && made->way != AdvancedEdge::Way::existing) follow_change(made->change);
    return made;
}

bool Simulation::grow(std::span<const CrackStep> crack_steps, Index stage) {
    bool changed = false;
    std::vector<CrackStep> ready;
    for (CrackStep one : crack_steps) {
        if (!one.edge.is_valid()) {
            const auto made = make_edge(one, ready);
            changed = changed || (made && made->way != AdvancedEdge::Way::existing);
            if (!made || !growth.take(*made, time(), one)) continue;
        }
        if (std::ranges::find(ready, one.edge, &CrackStep::edge) == ready.end()) ready.push_back(one);
    }
    std::vector<CrackStep> gone;
    for (const CrackStep& one : ready) {
        if (allowed({one.edge}).empty()) continue;
        break_by_toughness(one.edge, stage);
        gone.push_back(one);
    }
    grown += static_cast<Index>(gone.size());
    growth.done(gone, time() + step_size.size());
    return changed || !gone.empty();
}

void Simulation::break_by_toughness(Edge edge, Index stage) {
    const Positions& rest = breakable.mechanics().rest;
    const Vertex from = breakable.mesh().vertex(edge, 0);
    const Vector3d to = rest.col(static_cast<Index>(breakable.mesh().vertex(edge, 1)));
    const double released =
        residual_release(breakable, from, to) * (to - rest.col(static_cast<Index>(from))).norm();
    residual -= released;
    break_edges(std::array{edge}, measured().hinges, stage, opening_of(edge, released));
}

std::optional<Opening> Simulation::opening_of(Edge edge, double has) const {
    const Shell& shell = breakable.mechanics();
    const auto a = static_cast<Index>(breakable.mesh().vertex(edge, 0)),
               b = static_cast<Index>(breakable.mesh().vertex(edge, 1));
    const double length = (shell.rest.col(a) - shell.rest.col(b)).norm();
    const Toughness& toughness = breakable.toughness(edge);
    const double needed =
        toughness.value * toughness.value / shell.young[a] * length * mean_thickness(shell, std::array{a, b});
    if (has >= needed) return std::nullopt;
    return Opening{static_cast<Index>(edge), needed - has, length / toughness.speed_limit};
}

void Simulation::record_failures(std::span<const Edge> edges, const HingeMeasures& measures, Index stage) {
    const Mesh& mesh = breakable.mesh();
    for (const Edge edge : edges) {
        EdgeFailure failure;
        failure.step = steps;
        failure.stage = stage;
        failure.edge = static_cast<Index>(edge);
        failure.vertices = {static_cast<Index>(mesh.vertex(edge, 0)),
                            static_cast<Index>(mesh.vertex(edge, 1))};
        const Index hinge = breakable.hinge_of_edge(edge);
        failure.strain = measures.strain[hinge];
        failure.stress = measures.stress[hinge];
        failure.overload = overload(breakable, measures, edge, options.rule == BreakingRule::staged);
        events.failures.push_back(failure);
    }
}

void Simulation::record_change(const CrackMesh::Change& change) {
    const std::size_t first = events.failures.size() - change.boundary_vertices.size();
    for (std::size_t i = 0; i < change.boundary_vertices.size(); ++i)
        events.failures[first + i].boundary_vertices = change.boundary_vertices[i];
    for (const auto& [edge, created] : change.topology.opened)
        events.openings.push_back({0, steps, static_cast<Index>(edge), static_cast<Index>(created)});
    append_births(change.topology, steps, events);
}

}  // namespace sherd
