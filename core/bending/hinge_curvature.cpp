// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/hinge_curvature.h"

#include <cmath>
#include <numbers>

#include "core/elements/mid_edge.h"

namespace sherd {

Vector3d curvature_of_hinge(const RestHinge& rest, const MembraneTriangle& face, int corner, double strain,
                            AngleShare share) {
    const double turn = strain * rest.area / rest.edge_length;
    const Vector2d n = side_normal(face, corner);
    // Both faces have the edge in common, so that heights are in proportion to areas.
    const double twice = share == AngleShare::equal ? 1 : 2 * face.area / rest.area;
    return twice * turn / n.norm() * Vector3d(n.x() * n.x(), n.y() * n.y(), 2 * n.x() * n.y());
}

Eigen::Matrix3Xd curvatures_of_hinges(const Shell& shell, std::span<const std::array<TriangleEdge, 2>> sides,
                                      const VectorXd& strains, AngleShare share) {
    Eigen::Matrix3Xd curvatures =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(shell.triangles.size()));
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (const auto& [triangle, corner] : sides[i])
            curvatures.col(triangle) +=
                curvature_of_hinge(shell.hinges[i].rest, shell.triangles[triangle].membrane, corner,
                                   strains[static_cast<Eigen::Index>(i)], share);
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
