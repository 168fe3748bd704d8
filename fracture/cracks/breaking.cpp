// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/breaking.h"

#include <algorithm>
#include <limits>

namespace sherd {
namespace {

constexpr int rings = 2;
constexpr double almost_one = 1 - 1e-9;  // factor on a limit, which allows for round-off

/// The end points of an edge and all vertices within two edges of them.
std::vector<Vertex> neighbourhood(const Mesh& mesh, Edge edge) {
    std::vector<Vertex> vertices{mesh.vertex(edge, 0), mesh.vertex(edge, 1)};
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const std::size_t end = vertices.size();
        for (; begin < end; ++begin)
            for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertices[begin])))
                if (std::find(vertices.begin(), vertices.end(), mesh.source(h)) == vertices.end())
                    vertices.push_back(mesh.source(h));
    }
    return vertices;
}

/// Whether the overload of the hinge of `edge` may exceed `limit`: a cheap test that excludes most edges.
/// crack_tips: see overload().
bool may_exceed(const BreakableShell& shell, const HingeMeasures& measures, Edge edge, bool crack_tips,
                double limit) {
    const double factor = crack_tips ? std::min(1.0, shell.crack_tip_factor(edge)) : 1;
    return overload(shell, measures, edge, false) > factor * limit;
}

bool continues_a_crack(const BreakableShell& shell, Edge edge) {
    return shell.cracks().is_tip(shell.mesh().vertex(edge, 0)) ||
           shell.cracks().is_tip(shell.mesh().vertex(edge, 1));
}

}  // namespace

double overload(const BreakableShell& shell, const HingeMeasures& measures, Edge edge, bool crack_tips) {
    const Index hinge = shell.hinge_of_edge(edge);
    return hinge < 0 ? 0 : overload(shell, measures.at(hinge), edge, crack_tips);
}

double overload(const BreakableShell& shell, const HingeMeasure& of_hinge, Edge edge, bool crack_tips) {
    const double measure = of_hinge.of(shell.measure(edge));
    if (measure <= 0) return 0;
    const double factor = crack_tips && continues_a_crack(shell, edge) ? shell.crack_tip_factor(edge) : 1;
    // Recordings hold finite numbers, so the overload is finite at zero strength, too.
    return std::min(measure / (shell.strength(edge) * factor), std::numeric_limits<double>::max());
}

std::vector<Edge> most_overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures) {
    const Mesh& mesh = shell.mesh();
    const auto beats = [&](Edge edge, double ratio, Edge other) {
        const double rival = overload(shell, measures, other, true);
        return rival > ratio || (rival == ratio && other < edge);
    };
    std::vector<Edge> failing;
    for (std::size_t i = 0; i < shell.mechanics().hinges.size(); ++i) {
        const Edge edge = shell.edge_of_hinge(i);
        if (!may_exceed(shell, measures, edge, true, almost_one)) continue;
        const double ratio = overload(shell, measures, edge, true);
        if (!(ratio > 1) || shell.toughness(edge).given()) continue;
        bool most = true;
        for (const Vertex vertex : neighbourhood(mesh, edge))
            for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex)))
                most = most && (mesh.edge(h) == edge || !beats(edge, ratio, mesh.edge(h)));
        if (most) failing.push_back(edge);
    }
    std::sort(failing.begin(), failing.end());
    return failing;
}

double largest_overload(const BreakableShell& shell, const HingeMeasures& measures, bool crack_tips) {
    double largest = 0;
    for (std::size_t i = 0; i < shell.mechanics().hinges.size(); ++i) {
        const Edge edge = shell.edge_of_hinge(i);
        if (may_exceed(shell, measures, edge, crack_tips, almost_one * largest))
            largest = std::max(largest, overload(shell, measures, edge, crack_tips));
    }
    return largest;
}

bool bears_half(const BreakableShell& shell, const HingeMeasures& measures, bool crack_tips) {
    constexpr double half = 0.5;
    for (std::size_t i = 0; i < shell.mechanics().hinges.size(); ++i) {
        const Edge edge = shell.edge_of_hinge(i);
        if (!shell.toughness(edge).given() && may_exceed(shell, measures, edge, crack_tips, half) &&
            overload(shell, measures, edge, crack_tips) > half)
            return true;
    }
    return false;
}

std::vector<Edge> overloaded_edges(const BreakableShell& shell, const HingeMeasures& measures) {
    std::vector<Edge> failing;
    for (std::size_t i = 0; i < shell.mechanics().hinges.size(); ++i) {
        const Edge edge = shell.edge_of_hinge(i);
        if (overload(shell, measures, edge, false) > 1 && !shell.toughness(edge).given())
            failing.push_back(edge);
    }
    std::sort(failing.begin(), failing.end());
    return failing;
}

}  // namespace sherd
