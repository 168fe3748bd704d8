// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_growth.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tips/crack_tip.h"

namespace sherd {
namespace {

/// K = stress ahead sqrt(2 pi alpha h): of coupled hinges, from 18 tips in bending.
constexpr double alpha = 0.49;
/// A face is ahead whose centre is less than 72 degrees off the direction.
constexpr double ahead = 0.3;
/// An edge may leave the direction by 78 degrees: with less a structured mesh has none at all in some
/// directions.
constexpr double least_progress = 0.2;
/// Tips in bending turn no faster than on this radius, in thicknesses: the petals that rise behind them would
/// lead them round.
constexpr double radius_of_turns = 20;
/// Within these of a tip, in thicknesses and in edges, no crack is born.
constexpr double quiet_thicknesses = 4, quiet_edges = 2.5;
/// Of two tips this near, in edges, only the one that bears more goes on at a time.
constexpr double apart_edges = 2;
/// Share of the principal tension that some edge of any mesh has across it.
constexpr double least_share = 0.5;
/// How many times the way through the thickness at the speed limit a birth takes.
constexpr double delay = 2;

double mean_edge(const Shell& shell, Index face) {
    return std::sqrt(4 / std::sqrt(3.0) * shell.triangles[face].membrane.area);
}

double poisson(const Shell& shell, Index face) {
    const Matrix3d& elasticity = shell.triangles[face].membrane.elasticity;
    return elasticity(0, 1) / std::sqrt(elasticity(0, 0) * elasticity(1, 1));
}

/// Angle of the largest hoop stress, by the ratio of shear to opening.
double turn_of(double ratio) {
    return std::abs(ratio) < 1e-12 ? 0 : 2 * std::atan((1 - std::sqrt(1 + 8 * ratio * ratio)) / (4 * ratio));
}

}  // namespace

CrackGrowth::CrackGrowth(const BreakableShell& shell, bool timeless) : shell(shell), timeless(timeless) {
    for (const Index sheet : shell.face_sheet())
        is_needed = is_needed || shell.toughness_of_sheet(sheet).given();
    if (is_needed) find_tips();
}

void CrackGrowth::find_tips() {
    const Mesh& mesh = shell.mesh();
    for (const Vertex vertex : mesh.vertices()) {
        if (!shell.cracks().is_tip(vertex)) continue;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
            if (shell.cracks().state(mesh.edge(h)) == EdgeState::interior) continue;
            const Positions& rest = shell.mechanics().rest;
            add_tip(vertex,
                    rest.col(static_cast<Index>(vertex)) - rest.col(static_cast<Index>(mesh.source(h))), 0);
            break;
        }
    }
}

double CrackGrowth::edge_length_ahead(const GrowingTip& tip) const {
    const Shell& mechanics = shell.mechanics();
    double sum = 0;
    int count = 0;
    for (const Halfedge h : shell.mesh().halfedges_around_target(shell.mesh().halfedge(Vertex(tip.vertex)))) {
        const Vector3d way =
            mechanics.rest.col(static_cast<Index>(shell.mesh().source(h))) - mechanics.rest.col(tip.vertex);
        if (way.dot(tip.direction) <= 0) continue;
        sum += way.norm();
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

TipLoad CrackGrowth::load(const GrowingTip& tip, const FaceStrains& strains) const {
    const Shell& mechanics = shell.mechanics();
    SurfaceStress stress;
    std::vector<Index> faces;
    for (const Index face : faces_around(shell.mesh(), Vertex(tip.vertex))) {
        const Vector3d to = columns(mechanics.rest, mechanics.triangles[face].vertices).rowwise().mean() -
                            mechanics.rest.col(tip.vertex);
        if (to.dot(tip.direction) > ahead * to.norm()) faces.push_back(face);
    }
    if (faces.empty()) return {};
    for (const Index face : faces)
        stress += surface_stress(mechanics, face, strains) * (1.0 / static_cast<double>(faces.size()));
    const Vector3d left = rest_normal_at(shell, Vertex(tip.vertex)).cross(tip.direction).normalized();
    const double top = left.dot(stress.top * left), bottom = left.dot(stress.bottom * left);
    const double mean = std::max(0.5 * (top + bottom), 0.0), bend = 0.5 * std::abs(top - bottom);
    const double nu = poisson(mechanics, faces.front()), release = (1 + nu) / (3 * (3 + nu));
    const double length = edge_length_ahead(tip);
    TipLoad load;
    load.intensity = std::sqrt((mean * mean + release * bend * bend) * 2 * std::numbers::pi * alpha * length);
    const Matrix3d& pulled = top > bottom ? stress.top : stress.bottom;
    const double opening = std::max(top, bottom);
    if (!(opening > 0)) return load;
    load.angle = turn_of(left.dot(pulled * tip.direction) / opening);
    if (bend > mean) {
        const double most = length / (radius_of_turns * mechanics.thickness[tip.vertex]);
        load.angle = std::clamp(load.angle, -most, most);
    }
    return load;
}

bool CrackGrowth::can_fail(Edge edge) const {
    return shell.hinge_of_edge(edge) >= 0 && std::isfinite(shell.strength(edge));
}

std::optional<CrackGrowth::Advance> CrackGrowth::advance(std::size_t number, double angle,
                                                         double begin) const {
    const GrowingTip& tip = all[number];
    const Mesh& mesh = shell.mesh();
    const Positions& rest = shell.mechanics().rest;
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex));
    const Vector3d direction = Eigen::AngleAxisd(angle, normal) * tip.direction;
    const Vector3d left = normal.cross(direction);
    std::optional<Advance> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(tip.vertex)))) {
        const Edge edge = mesh.edge(h);
        const auto to = static_cast<Index>(mesh.source(h));
        const Vector3d way = rest.col(to) - rest.col(tip.vertex), away = rest.col(to) - tip.on_path;
        const double length = way.norm(), off = std::abs(away.dot(left)) / length;
        if (!can_fail(edge) || way.dot(direction) < least_progress * length || off >= least) continue;
        least = off;
        GrowingTip next{to, tip.on_path + away.dot(direction) * direction, direction, 0};
        const Vector3d gap = next.on_path - rest.col(to);
        if (gap.norm() > length) next.on_path = rest.col(to) + length * gap.normalized();
        const double limit = shell.toughness(edge).speed_limit;
        next.ready = timeless ? begin : std::max(tip.ready, begin) + way.dot(direction) / limit;
        best = Advance{number, edge, next};
    }
    if (best) {
        const Matrix3d turn = smallest_turn(normal, rest_normal_at(shell, Vertex(best->next.vertex)));
        best->next.direction = (turn * direction).normalized();
    }
    return best;
}

void CrackGrowth::choose_advances(const FaceStrains& strains, double begin, double end) {
    struct Overloaded {
        double ratio;
        Advance next;
    };
    std::vector<Overloaded> overloaded;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].ready > end) continue;
        const TipLoad now = load(all[i], strains);
        const auto next = now.intensity > 0 ? advance(i, now.angle, begin) : std::nullopt;
        if (!next) continue;
        const double ratio = now.intensity / shell.toughness(next->edge).value;
        if (ratio > 1) overloaded.push_back({ratio, *next});
    }
    std::ranges::stable_sort(overloaded, std::greater(), &Overloaded::ratio);
    const Positions& rest = shell.mechanics().rest;
    for (const Overloaded& one : overloaded) {
        const double reach = apart_edges * edge_length_ahead(all[one.next.tip]);
        const bool waits = std::ranges::any_of(advances, [&](const Advance& other) {
            return (rest.col(all[other.tip].vertex) - rest.col(all[one.next.tip].vertex)).norm() < reach;
        });
        if (!waits) advances.push_back(one.next);
    }
}

bool CrackGrowth::near_a_tip(Edge edge) const {
    const Shell& mechanics = shell.mechanics();
    const auto a = static_cast<Index>(shell.mesh().vertex(edge, 0)),
               b = static_cast<Index>(shell.mesh().vertex(edge, 1));
    const Vector3d middle = 0.5 * (mechanics.rest.col(a) + mechanics.rest.col(b));
    const Halfedge h = shell.mesh().halfedge(edge);
    const auto face = static_cast<Index>(shell.mesh().face(h));
    const double reach =
        std::max(quiet_thicknesses * mechanics.thickness[a], quiet_edges * mean_edge(mechanics, face));
    return std::ranges::any_of(
        all, [&](const GrowingTip& tip) { return (mechanics.rest.col(tip.vertex) - middle).norm() < reach; });
}

double CrackGrowth::birth_ratio(const FaceStrains& strains, double across, Edge edge) const {
    const Mesh& mesh = shell.mesh();
    if (mesh.is_border(mesh.vertex(edge, 0)) || mesh.is_border(mesh.vertex(edge, 1)) ||
        shell.has_directed_strength(edge))
        return across;
    SurfaceStress stress;
    for (const int side : {0, 1})
        stress += surface_stress(shell.mechanics(), static_cast<Index>(mesh.face(mesh.halfedge(edge, side))),
                                 strains) *
                  0.5;
    const auto tension = [](const Matrix3d& tensor) {
        return Eigen::SelfAdjointEigenSolver<Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues()[2];
    };
    return std::max(tension(stress.top), tension(stress.bottom)) / shell.strength(edge);
}

void CrackGrowth::choose_birth(const FaceStrains& strains, const HingeMeasures& measures, double end,
                               double waited) {
    const Shell& mechanics = shell.mechanics();
    exposure.resize(shell.mesh().number_of_edges(), 0);
    double largest = 0;
    for (std::size_t hinge = 0; hinge < mechanics.hinges.size(); ++hinge) {
        const Edge edge = shell.edge_of_hinge(hinge);
        const Toughness toughness = shell.toughness(edge);
        if (!toughness.given()) continue;
        const double across =
            measures.of(shell.measure(edge), static_cast<Index>(hinge)) / shell.strength(edge);
        const double ratio = across > 0 && across > least_share ? birth_ratio(strains, across, edge) : across;
        double& exposed = exposure[edge];
        if (!(ratio > 1)) {
            exposed = 0;
            continue;
        }
        exposed += (ratio - 1) * (ratio - 1) * waited;
        const double thickness = mechanics.thickness[mechanics.hinges[hinge].vertices[0]];
        const double needed = timeless ? 0 : delay * thickness / toughness.speed_limit;
        if (exposed < needed || across <= largest || near_a_tip(edge)) continue;
        largest = across;
        birth = edge;
    }
    birth_time = end;
}

std::vector<Edge> CrackGrowth::failing_edges(const FaceStrains& strains, const HingeMeasures& measures,
                                             double begin, double end, double waited) {
    advances.clear();
    birth.reset();
    if (!is_needed) return {};
    choose_advances(strains, begin, end);
    choose_birth(strains, measures, end, waited);
    std::vector<Edge> edges;
    for (const Advance& one : advances) edges.push_back(one.edge);
    if (birth) edges.push_back(*birth);
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

void CrackGrowth::add_tip(Vertex vertex, const Vector3d& direction, double time) {
    const Vector3d normal = rest_normal_at(shell, vertex);
    const auto number = static_cast<Index>(vertex);
    all.push_back({number, shell.mechanics().rest.col(number),
                   (direction - normal * normal.dot(direction)).normalized(), time});
}

void CrackGrowth::failed() {
    for (const Advance& one : advances) all[one.tip] = one.next;
    if (birth) {
        const Vertex a = shell.mesh().vertex(*birth, 0), b = shell.mesh().vertex(*birth, 1);
        const Vector3d way = shell.mechanics().rest.col(static_cast<Index>(b)) -
                             shell.mechanics().rest.col(static_cast<Index>(a));
        const double limit = shell.toughness_of_sheet(shell.sheet_of(*birth)).speed_limit;
        const double ready = birth_time + (timeless ? 0 : 0.5 * way.norm() / limit);
        add_tip(a, -way, ready);
        add_tip(b, way, ready);
    }
    // A tip that has arrived at the boundary or at another crack is none any more.
    std::erase_if(all, [&](const GrowingTip& tip) { return !shell.cracks().is_tip(Vertex(tip.vertex)); });
    advances.clear();
    birth.reset();
}

}  // namespace sherd
