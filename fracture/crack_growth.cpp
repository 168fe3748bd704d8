// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_growth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fracture/tip_stress.h"

namespace sherd {
namespace {

/// An edge may leave the direction by 78 degrees: with less a structured mesh has none at all in some
/// directions.
constexpr double least_progress = 0.2;
/// Of two tips this near, in edges, only the one that bears more goes on at a time.
constexpr double apart_edges = 2;

}  // namespace

CrackGrowth::CrackGrowth(const BreakableShell& shell, MembraneModel membrane, bool timeless)
    : shell(shell), membrane(membrane), timeless(timeless), birth(shell, timeless), energy(shell) {
    for (const Index sheet : shell.face_sheet())
        is_needed = is_needed || shell.toughness_of_sheet(sheet).given();
    if (!is_needed) return;
    find_tips();
    energy.mesh_changed(all);
}

void CrackGrowth::find_tips() {
    const Mesh& mesh = shell.mesh();
    for (const Vertex vertex : mesh.vertices()) {
        const auto number = static_cast<Index>(vertex);
        if (!shell.cracks().is_tip(vertex)) continue;
        if (!shell.toughness_of_sheet(shell.mechanics().vertex_sheet[number]).given()) continue;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
            if (shell.cracks().state(mesh.edge(h)) == EdgeState::interior) continue;
            const Positions& rest = shell.mechanics().rest;
            add_tip(vertex, rest.col(number) - rest.col(static_cast<Index>(mesh.source(h))), mesh.edge(h), 0);
            break;
        }
    }
}

const Toughness& CrackGrowth::toughness(const GrowingTip& tip) const {
    return shell.toughness_of_sheet(shell.mechanics().vertex_sheet[tip.vertex]);
}

TipLoad CrackGrowth::load(const GrowingTip& tip, const Judged& now) {
    if (now.equilibrium)
        if (const std::optional<TipLoad> by_energy = energy.load(tip, *now.equilibrium, membrane))
            return *by_energy;
    return load_by_stress(shell, tip, now.strains);
}

std::vector<CrackGrowth::Overloaded> CrackGrowth::overloaded(const Judged& now) {
    std::vector<Overloaded> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].ready > now.end || now.is_opening(all[i].behind)) continue;
        const TipLoad bears = load(all[i], now);
        const double ratio = bears.intensity / toughness(all[i]).value;
        if (ratio > 1) found.push_back({i, ratio, bears.direction});
    }
    std::ranges::stable_sort(found, std::greater(), &Overloaded::ratio);
    const Positions& rest = shell.mechanics().rest;
    std::vector<Overloaded> apart;
    for (const Overloaded& one : found) {
        const double reach = apart_edges * edge_length_ahead(shell, all[one.tip]);
        const bool waits = std::ranges::any_of(apart, [&](const Overloaded& other) {
            return (rest.col(all[other.tip].vertex) - rest.col(all[one.tip].vertex)).norm() < reach;
        });
        if (!waits) apart.push_back(one);
    }
    return apart;
}

std::optional<CrackStep> CrackGrowth::step(const Overloaded& one, double begin) const {
    const GrowingTip& tip = all[one.tip];
    const Mesh& mesh = shell.mesh();
    const Positions& rest = shell.mechanics().rest;
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex)), left = normal.cross(one.direction);
    std::optional<CrackStep> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(tip.vertex)))) {
        const Edge edge = mesh.edge(h);
        const auto to = static_cast<Index>(mesh.source(h));
        const Vector3d way = rest.col(to) - rest.col(tip.vertex), away = rest.col(to) - tip.on_path;
        const double length = way.norm(), off = std::abs(away.dot(left)) / length;
        if (!shell.can_fail(edge) || way.dot(one.direction) < least_progress * length || off >= least)
            continue;
        least = off;
        GrowingTip next{to, tip.on_path + away.dot(one.direction) * one.direction, one.direction, 0,
                        static_cast<Index>(edge)};
        const Vector3d gap = next.on_path - rest.col(to);
        if (gap.norm() > length) next.on_path = rest.col(to) + length * gap.normalized();
        const double limit = toughness(tip).speed_limit;
        next.ready = timeless ? begin : std::max(tip.ready, begin) + way.dot(one.direction) / limit;
        best = CrackStep{one.tip, edge, next};
    }
    if (best) {
        const Matrix3d turn = smallest_turn(normal, rest_normal_at(shell, Vertex(best->next.vertex)));
        best->next.direction = (turn * one.direction).normalized();
    }
    return best;
}

std::vector<CrackStep> CrackGrowth::next(const Judged& now) {
    std::vector<CrackStep> steps;
    if (!is_needed) return steps;
    for (const Overloaded& one : overloaded(now))
        if (const std::optional<CrackStep> found = step(one, now.begin)) steps.push_back(*found);
    if (const std::optional<Edge> born = birth.next(now.strains, now.measures, all, now.waited))
        steps.push_back({{}, *born, {}});
    // Two tips that meet take the same edge.
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps.erase(std::remove_if(steps.begin() + static_cast<std::ptrdiff_t>(i) + 1, steps.end(),
                                   [&](const CrackStep& other) { return other.edge == steps[i].edge; }),
                    steps.end());
    return steps;
}

void CrackGrowth::add_tip(Vertex vertex, const Vector3d& direction, Edge behind, double ready) {
    const Vector3d normal = rest_normal_at(shell, vertex);
    const auto number = static_cast<Index>(vertex);
    all.push_back({number, shell.mechanics().rest.col(number),
                   (direction - normal * normal.dot(direction)).normalized(), ready,
                   static_cast<Index>(behind)});
}

void CrackGrowth::done(std::span<const CrackStep> steps, double end) {
    for (const auto& [tip, edge, next] : steps) {
        if (tip) {
            all[*tip] = next;
            continue;
        }
        const Vertex a = shell.mesh().vertex(edge, 0), b = shell.mesh().vertex(edge, 1);
        const Vector3d way = shell.mechanics().rest.col(static_cast<Index>(b)) -
                             shell.mechanics().rest.col(static_cast<Index>(a));
        const double limit = shell.toughness(edge).speed_limit;
        const double ready = end + (timeless ? 0 : 0.5 * way.norm() / limit);
        add_tip(a, -way, edge, ready);
        add_tip(b, way, edge, ready);
    }
    // A tip that has arrived at the boundary or at another crack is none any more.
    std::erase_if(all, [&](const GrowingTip& tip) { return !shell.cracks().is_tip(Vertex(tip.vertex)); });
    mesh_changed();
}

}  // namespace sherd
