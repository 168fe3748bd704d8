// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/crack_growth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "fracture/cracks/crack_branching.h"
#include "fracture/cracks/residual_stress.h"
#include "fracture/cracks/tip_stress.h"
#include "fracture/cracks/weakest_direction.h"

namespace sherd {
namespace {

/// Cosine of the largest angle, 78 degrees, between an edge and the direction in which a tip propagates along
/// it. With a smaller angle, a structured mesh would have no edge at all in some directions.
constexpr double least_progress = 0.2;
/// Distance, in edge lengths, below which only the more overloaded of two tips propagates at a time.
constexpr double apart_edges = 2;
/// Smallest ratio of intensity to toughness at which a tip is recorded.
constexpr double least_recorded = 0.1;
/// Ratio of intensity to toughness below which a tip that stands still does not propagate soon.
constexpr double low_load = 0.5;

}  // namespace

CrackGrowth::CrackGrowth(const BreakableShell& shell, MembraneModel membrane, bool timeless)
    : shell(shell), timeless(timeless), nucleation(shell, timeless), energy(shell, membrane) {
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
        if (!shell.toughness_at(number).given()) continue;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
            if (shell.cracks().state(mesh.edge(h)) == EdgeState::interior) continue;
            const Positions& rest = shell.mechanics().rest;
            add_tip(vertex, rest.col(number) - rest.col(static_cast<Index>(mesh.source(h))), mesh.edge(h), 0);
            break;
        }
    }
}

TipLoad CrackGrowth::load(const GrowingTip& tip, const CrackEvaluation& now) {
    std::optional<TipLoad> load;
    if (now.equilibrium) load = energy.load(tip, *now.equilibrium);
    if (!load) load = load_by_stress(shell, tip, now.strains);
    add_residual(shell, tip, *load);
    return *load;
}

void CrackGrowth::evaluate_tips(const CrackEvaluation& now) {
    evaluated.clear();
    for (GrowingTip& tip : all) {
        TipLoad bears = load(tip, now);
        if (shell.toughness_at(tip.vertex).has_directions()) turn_to_weakest(shell, tip, bears);
        const double ratio = bears.intensity / shell.toughness_towards(Vertex(tip.vertex), bears.direction);
        evaluated.push_back({tip.number, bears, ratio, tip.ready <= now.end && !now.is_opening(tip.behind)});
        if (!timeless) update_mean_release(shell, tip, bears, ratio, now.waited);
    }
}

double CrackGrowth::joint_ratio(std::size_t tip) const {
    if (!evaluated[tip].is_ready) return 0;
    const GrowingTip* other_branch = near_branch(shell, all[tip], all);
    if (other_branch == nullptr) return evaluated[tip].ratio;
    const EvaluatedTip& other = evaluated[other_branch - all.data()];
    return other.is_ready ? std::hypot(evaluated[tip].ratio, other.ratio) / std::numbers::sqrt2 : 0;
}

std::vector<CrackGrowth::Overloaded> CrackGrowth::overloaded() const {
    std::vector<Overloaded> found;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const double ratio = joint_ratio(i); ratio > 1)
            found.push_back({i, ratio, evaluated[i].load.direction});
    std::ranges::stable_sort(found, std::greater(), &Overloaded::ratio);
    const Positions& rest = shell.mechanics().rest;
    std::vector<Overloaded> apart;
    for (const Overloaded& one : found) {
        const GrowingTip& tip = all[one.tip];
        const double reach = apart_edges * edge_length_ahead(shell, tip);
        const bool waits = std::ranges::any_of(apart, [&](const Overloaded& before) {
            const GrowingTip& other = all[before.tip];
            return other.number != tip.other_branch &&
                   (rest.col(other.vertex) - rest.col(tip.vertex)).norm() < reach;
        });
        if (!waits) apart.push_back(one);
    }
    return apart;
}

GrowingTip CrackGrowth::moved(const GrowingTip& tip, const Vector3d& direction, Edge edge, Index to,
                              double begin) const {
    const Positions& rest = shell.mechanics().rest;
    const Vector3d way = rest.col(to) - rest.col(tip.vertex), away = rest.col(to) - tip.on_path;
    GrowingTip next = tip;
    next.vertex = to;
    next.on_path += away.dot(direction) * direction;
    const Vector3d gap = next.on_path - rest.col(to);
    if (gap.norm() > way.norm()) next.on_path = rest.col(to) + way.norm() * gap.normalized();
    const Matrix3d turn =
        smallest_turn(rest_normal_at(shell, Vertex(tip.vertex)), rest_normal_at(shell, Vertex(to)));
    next.direction = (turn * direction).normalized();
    next.behind = static_cast<Index>(edge);
    next.stride = way.dot(direction);
    const double limit = shell.toughness_at(tip.vertex).speed_limit;
    if (timeless) return next;
    // The tip begins its edge when it is ready, within the step: if it always began with the step, its speed
    // would jump.
    next.since = std::max(tip.ready, begin);
    next.before = tip.stride > 0 ? tip.stride / (next.since - tip.since) : limit;
    next.ready = next.since + next.stride / limit;
    return next;
}

std::optional<CrackStep> CrackGrowth::along_edges(const Overloaded& one, double begin) const {
    const GrowingTip& tip = all[one.tip];
    const Mesh& mesh = shell.mesh();
    const Positions& rest = shell.mechanics().rest;
    const Vector3d left = rest_normal_at(shell, Vertex(tip.vertex)).cross(one.direction);
    Edge best = Edge();
    Index end = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(tip.vertex)))) {
        const auto to = static_cast<Index>(mesh.source(h));
        const Vector3d way = rest.col(to) - rest.col(tip.vertex), away = rest.col(to) - tip.on_path;
        const double length = way.norm(), off = std::abs(away.dot(left)) / length;
        if (!shell.can_fail(mesh.edge(h)) || way.dot(one.direction) < least_progress * length || off >= least)
            continue;
        least = off;
        best = mesh.edge(h);
        end = to;
    }
    if (!best.is_valid()) return std::nullopt;
    return CrackStep{one.tip, best, one.direction, moved(tip, one.direction, best, end, begin)};
}

CrackStep CrackGrowth::along_ray(const Overloaded& one) const {
    const GrowingTip& tip = all[one.tip];
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex));
    // Where the last edge missed the path, the ray leads back to it.
    const Vector3d aim =
        tip.on_path + edge_length_ahead(shell, tip) * one.direction - shell.mechanics().rest.col(tip.vertex);
    const Vector3d ray = (aim - normal * normal.dot(aim)).normalized();
    CrackStep step{one.tip, Edge(), ray, tip};
    step.next.direction = one.direction;
    return step;
}

bool CrackGrowth::take(const BreakableShell::Advanced& made, double begin, CrackStep& step) const {
    const Mesh& mesh = shell.mesh();
    const GrowingTip& tip = all[*step.tip];
    const auto to = static_cast<Index>(mesh.target(made.halfedge));
    const Vector3d way = shell.mechanics().rest.col(to) - shell.mechanics().rest.col(tip.vertex);
    step.edge = mesh.edge(made.halfedge);
    if (!shell.can_fail(step.edge) || way.dot(step.ray) < least_progress * way.norm()) return false;
    step.next = moved(tip, step.next.direction, step.edge, to, begin);
    return true;
}

std::vector<Vector3d> CrackGrowth::directions_of(const Overloaded& one, double end) {
    GrowingTip& tip = all[one.tip];
    if (timeless || !branches(shell, tip, evaluated[one.tip].load, all, end)) return {one.direction};
    tip.on_path = shell.mechanics().rest.col(tip.vertex);
    tip.release = 0;
    const std::array<Vector3d, 2> both = branch_directions(shell, tip, one.direction);
    return {both.begin(), both.end()};
}

std::optional<CrackStep> CrackGrowth::step_of(const Overloaded& one, double begin) const {
    if (shell.toughness_at(all[one.tip].vertex).path == CrackPath::edges) return along_edges(one, begin);
    return along_ray(one);
}

std::vector<CrackStep> CrackGrowth::next(const CrackEvaluation& now) {
    std::vector<CrackStep> steps;
    if (!is_needed) return steps;
    // Nucleation comes first, since its edge is an edge of the mesh before edges are inserted in it.
    if (const std::optional<Edge> inserted = nucleation.next(now.strains, now.measures, all, now.waited))
        steps.push_back({{}, *inserted});
    evaluate_tips(now);
    for (const Overloaded& one : overloaded()) {
        const std::vector<Vector3d> ways = directions_of(one, now.end);
        for (const Vector3d& way : ways) {
            std::optional<CrackStep> step = step_of({one.tip, one.ratio, way}, now.begin);
            if (!step) continue;
            step->is_branch = &way != &ways.front();
            steps.push_back(*step);
        }
    }
    return steps;
}

double CrackGrowth::time_left(double time) const {
    if (!is_needed) return std::numeric_limits<double>::infinity();
    const bool moves = std::ranges::any_of(
        all, [&](const GrowingTip& tip) { return time < tip.ready + (tip.ready - tip.since); });
    const bool bears =
        std::ranges::any_of(evaluated, [](const EvaluatedTip& tip) { return tip.ratio >= low_load; });
    return moves || bears ? 0 : nucleation.time_left();
}

void CrackGrowth::add_tip(Vertex vertex, const Vector3d& direction, Edge behind, double ready) {
    const Vector3d normal = rest_normal_at(shell, vertex);
    GrowingTip tip;
    tip.vertex = static_cast<Index>(vertex);
    tip.on_path = shell.mechanics().rest.col(tip.vertex);
    tip.direction = (direction - normal * normal.dot(direction)).normalized();
    tip.ready = ready;
    tip.behind = static_cast<Index>(behind);
    tip.number = numbers++;
    all.push_back(tip);
}

void CrackGrowth::add_branch(GrowingTip tip) {
    const auto first = std::ranges::find(all, tip.number, &GrowingTip::number);
    tip.other_branch = tip.number;
    tip.number = numbers++;
    first->other_branch = tip.number;
    all.push_back(tip);
}

void CrackGrowth::done(std::span<const CrackStep> steps, double end) {
    for (const auto& [number, edge, ray, next, is_branch] : steps) {
        if (is_branch) {
            add_branch(next);
            continue;
        }
        if (number) {
            all[*number] = next;
            continue;
        }
        const Vertex a = shell.mesh().vertex(edge, 0), b = shell.mesh().vertex(edge, 1);
        const Vector3d way = shell.mechanics().rest.col(static_cast<Index>(b)) -
                             shell.mechanics().rest.col(static_cast<Index>(a));
        const double limit = shell.toughness(edge).speed_limit;
        const double ready = end + (timeless ? 0 : 0.5 * way.norm() / limit);
        for (const auto& [at, direction] : {std::pair(a, Vector3d(-way)), std::pair(b, way)}) {
            add_tip(at, direction, edge, ready);
            // The crack began in the middle of its first edge.
            all.back().since = end - (timeless ? 0 : 0.5 * way.norm() / limit);
        }
    }
    // A tip that has reached the boundary or another crack is no longer a tip.
    std::erase_if(all, [&](const GrowingTip& tip) { return !shell.cracks().is_tip(Vertex(tip.vertex)); });
    mesh_changed();
}

std::vector<TipRecord> CrackGrowth::records(const Positions& x, double time) const {
    const Shell& mechanics = shell.mechanics();
    std::vector<TipRecord> records;
    for (const auto& [number, load, ratio, is_ready] : evaluated) {
        const auto now = std::ranges::find(all, number, &GrowingTip::number);
        if (now == all.end()) continue;
        const double needed = shell.toughness_towards(Vertex(now->vertex), now->direction);
        if (load.intensity < least_recorded * needed) continue;
        Vector3d direction = Vector3d::Zero();
        for (const Index face : faces_around(shell.mesh(), Vertex(now->vertex))) {
            const auto& [vertices, membrane] = mechanics.triangles[face];
            direction +=
                membrane.area * (deformation_gradient(membrane, columns(x, vertices)) *
                                 frame_axes(columns(mechanics.rest, vertices)).transpose() * now->direction);
        }
        const double young = mechanics.young[now->vertex];
        TipRecord record;
        record.tip = number;
        record.vertex = now->vertex;
        record.position = x.col(now->vertex);
        record.direction = direction.normalized();
        record.speed = timeless ? 0 : now->speed(time);
        record.released = load.intensity * load.intensity / young;
        record.toughness = needed * needed / young;
        record.by_energy = load.by_energy;
        record.opening = load.membrane.first;
        record.shear = load.membrane.second;
        record.bending = load.plate.first;
        record.twist = load.plate.second;
        records.push_back(record);
    }
    return records;
}

}  // namespace sherd
