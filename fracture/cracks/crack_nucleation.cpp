// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/crack_nucleation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

/// Distances from a tip, in thicknesses and in edge lengths, of which the larger is the radius in which no
/// crack nucleates.
constexpr double quiet_thicknesses = 4, quiet_edges = 2.5;
/// In a mesh without slivers, at least this share of the principal tension acts across one of the edges
/// around a point. The principal tension is therefore compared with the strength only where the tension
/// across an edge exceeds this share of the strength.
constexpr double least_share = 0.5;
/// Time for nucleation at twice the strength, over the time in which a crack at its speed limit crosses the
/// thickness.
constexpr double delay = 2;
/// Factor on the stress for CrackNucleation::time_left().
constexpr double sudden_growth = 1.5;

double mean_edge(const Shell& shell, Index face) {
    return std::sqrt(4 / std::sqrt(3.0) * shell.triangles[face].membrane.area);
}

double largest_tension(const Matrix3d& stress) {
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(stress, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

}  // namespace

bool CrackNucleation::near_a_tip(Edge edge, std::span<const GrowingTip> tips) const {
    const Shell& mechanics = shell.mechanics();
    const auto a = static_cast<Index>(shell.mesh().vertex(edge, 0)),
               b = static_cast<Index>(shell.mesh().vertex(edge, 1));
    const Vector3d middle = 0.5 * (mechanics.rest.col(a) + mechanics.rest.col(b));
    const auto face = static_cast<Index>(shell.mesh().face(shell.mesh().halfedge(edge)));
    const double reach =
        std::max(quiet_thicknesses * mechanics.thickness[a], quiet_edges * mean_edge(mechanics, face));
    return std::ranges::any_of(tips, [&](const GrowingTip& tip) {
        return mechanics.vertex_sheet[tip.vertex] == mechanics.vertex_sheet[a] &&
               (mechanics.rest.col(tip.vertex) - middle).norm() < reach;
    });
}

double CrackNucleation::ratio(const FaceStrains& strains, double across, Edge edge) const {
    const Mesh& mesh = shell.mesh();
    if (mesh.is_border(mesh.vertex(edge, 0)) || mesh.is_border(mesh.vertex(edge, 1)) ||
        shell.has_directed_strength(edge))
        return across;
    SurfaceStress stress;
    for (const int side : {0, 1})
        stress += surface_stress(shell.mechanics(), static_cast<Index>(mesh.face(mesh.halfedge(edge, side))),
                                 strains) *
                  0.5;
    return std::max(largest_tension(stress.top), largest_tension(stress.bottom)) / shell.strength(edge);
}

std::optional<Edge> CrackNucleation::next(const FaceStrains& strains, const HingeMeasures& measures,
                                          std::span<const GrowingTip> tips, double waited) {
    const Shell& mechanics = shell.mechanics();
    exposure.resize(shell.mesh().number_of_edges(), 0);
    std::optional<Edge> inserted;
    double largest = 0;
    least_time = std::numeric_limits<double>::infinity();
    for (std::size_t hinge = 0; hinge < mechanics.hinges.size(); ++hinge) {
        const Edge edge = shell.edge_of_hinge(hinge);
        const Toughness toughness = shell.toughness(edge);
        if (!toughness.given()) continue;
        const double across =
            measures.of(shell.measure(edge), static_cast<Index>(hinge)) / shell.strength(edge);
        const double over = across > least_share ? ratio(strains, across, edge) : across;
        double& exposed = exposure[edge];
        exposed = over > 1 ? exposed + (over - 1) * (over - 1) * waited : 0;
        const double thickness = mechanics.thickness[mechanics.hinges[hinge].vertices[0]];
        const double needed = timeless ? 0 : delay * thickness / toughness.speed_limit;
        if (const double grown = sudden_growth * over - 1; grown > 0) {
            const double left = std::max(0.0, needed - exposed) / (grown * grown);
            if (left < least_time && !near_a_tip(edge, tips)) least_time = left;
        }
        if (!(over > 1)) continue;
        if (exposed < needed || across <= largest || near_a_tip(edge, tips)) continue;
        largest = across;
        inserted = edge;
    }
    return inserted;
}

}  // namespace sherd
