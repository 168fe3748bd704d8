// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/tip_stress.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tips/crack_direction.h"

namespace sherd {
namespace {

/// Factor in K = s sqrt(2 pi alpha h), with the stress s ahead of a tip and the length h of the edges there.
/// It was measured at 18 tips in bending, with coupled hinges.
constexpr double alpha = 0.49;
/// Cosine of the largest angle, 72 degrees, between a tip's direction and the line from the tip to the centre
/// of a face that counts as ahead of it.
constexpr double ahead = 0.3;
/// Smallest radius, in thicknesses, of the path of a tip that runs or is in bending. Without this limit waves
/// would make the path snake, and the petals that rise behind the tip would make it curl.
constexpr double radius_of_turns = 20;

double poisson(const Shell& shell, Index face) {
    const Matrix3d& elasticity = shell.triangles[face].membrane.elasticity;
    return elasticity(0, 1) / std::sqrt(elasticity(0, 0) * elasticity(1, 1));
}

std::vector<Index> faces_ahead(const BreakableShell& shell, const GrowingTip& tip) {
    const Shell& mechanics = shell.mechanics();
    std::vector<Index> faces;
    for (const Index face : faces_around(shell.mesh(), Vertex(tip.vertex))) {
        const Vector3d to = columns(mechanics.rest, mechanics.triangles[face].vertices).rowwise().mean() -
                            mechanics.rest.col(tip.vertex);
        if (to.dot(tip.direction) > ahead * to.norm()) faces.push_back(face);
    }
    return faces;
}

}  // namespace

double edge_length_ahead(const BreakableShell& shell, const GrowingTip& tip) {
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

double largest_tip_turn(const BreakableShell& shell, const GrowingTip& tip) {
    return edge_length_ahead(shell, tip) / (radius_of_turns * shell.mechanics().thickness[tip.vertex]);
}

TipLoad load_by_stress(const BreakableShell& shell, const GrowingTip& tip, const FaceStrains& strains) {
    const Shell& mechanics = shell.mechanics();
    TipLoad load;
    load.direction = tip.direction;
    const std::vector<Index> faces = faces_ahead(shell, tip);
    if (faces.empty()) return load;
    SurfaceStress stress;
    for (const Index face : faces)
        stress += surface_stress(mechanics, face, strains) * (1.0 / static_cast<double>(faces.size()));
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex));
    const Vector3d left = normal.cross(tip.direction).normalized();
    const ModePair top{left.dot(stress.top * left), left.dot(stress.top * tip.direction)},
        bottom{left.dot(stress.bottom * left), left.dot(stress.bottom * tip.direction)};
    const double mean = 0.5 * (top.first + bottom.first), bend = 0.5 * (bottom.first - top.first);
    const double length = edge_length_ahead(shell, tip), reach = 2 * alpha * length;
    load.membrane = {std::sqrt(std::numbers::pi * reach) * mean,
                     std::sqrt(std::numbers::pi * reach) * 0.5 * (top.second + bottom.second)};
    load.plate = {std::sqrt(reach) * bend, std::sqrt(reach) * 0.5 * (bottom.second - top.second)};
    const double nu = poisson(mechanics, faces.front()), release = (1 + nu) / (3 * (3 + nu));
    load.intensity =
        std::sqrt(std::numbers::pi * reach) * std::hypot(std::max(mean, 0.0), std::sqrt(release) * bend);
    const ModePair& pulled = top.first > bottom.first ? top : bottom;
    if (!(pulled.first > 0)) return load;
    double turn = hoop_angle(pulled);
    if (tip.stride > 0 || std::abs(bend) > std::max(mean, 0.0)) {
        const double most = largest_tip_turn(shell, tip);
        turn = std::clamp(turn, -most, most);
    }
    load.direction = Eigen::AngleAxisd(turn, normal) * tip.direction;
    return load;
}

}  // namespace sherd
