// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/hinge_curvature.h"

#include <cmath>
#include <numbers>

#include "core/elements/mid_edge.h"

namespace sherd {

Eigen::Matrix3Xd curvatures_of_hinges(const Shell& shell, std::span<const std::array<TriangleEdge, 2>> sides,
                                      const VectorXd& strains, AngleShare share) {
    Eigen::Matrix3Xd curvatures =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(shell.triangles.size()));
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const RestHinge& rest = shell.hinges[i].rest;
        const double turn = strains[static_cast<Eigen::Index>(i)] * rest.area / rest.edge_length;
        for (const auto& [triangle, corner] : sides[i]) {
            const MembraneTriangle& membrane = shell.triangles[triangle].membrane;
            const Vector2d n = side_normal(membrane, corner);
            // Both faces have the edge in common, so that heights are in proportion to areas.
            const double twice = share == AngleShare::equal ? 1 : 2 * membrane.area / rest.area;
            curvatures.col(triangle) +=
                twice * turn / n.norm() * Vector3d(n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y());
        }
    }
    return curvatures;
}

void add_mirror_curvatures(const Shell& shell, const Mirrors& mirrors, const Positions& x,
                           Eigen::Matrix3Xd& curvatures) {
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        const auto& [triangle, corner] = mirrors[m].side;
        const double turn = std::remainder(
            hinge_angle(mirrors.with_image(m, x)) - hinge_angle(mirrors.rest(m)), 2 * std::numbers::pi);
        const PlaneTriangle rest = plane_triangle(columns(shell.rest, shell.triangles[triangle].vertices));
        curvatures.col(triangle) += turn / 2 * curvature_of_tangent(rest, corner);
    }
}

}  // namespace sherd
