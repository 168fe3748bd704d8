// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/bending/mirror_hinge.h"

namespace sherd {

/// Division of the change of a hinge's angle between its two faces.
enum class AngleShare {
    equal,
    by_height,  ///< in proportion to heights over the edge, as for a constant curvature across it
};

/// Contribution of the hinge at one side of a face to the face's curvature, 1/m: see curvatures_of_hinges().
/// corner: the corner opposite to the side; strain: hinge_strain() of the hinge, 1/m.
Vector3d curvature_of_hinge(const RestHinge& rest, const MembraneTriangle& face, int corner, double strain,
                            AngleShare share);

/// The change of curvature of each face from the angles of its own hinges alone, [3, F], 1/m, as (00, 11, 2 *
/// 01) in the face's rest frame: the sum, over the face's sides, of length / area times n n^T times the
/// face's share of the change of angle, where n is the side's outward unit normal. Uncoupled hinges determine
/// no more than this estimate, which does not converge to the curvature of a plate (docs/theory/bending.md).
/// sides: sides_of_hinges(); strains: hinge_strain() of each hinge, 1/m.
Eigen::Matrix3Xd curvatures_of_hinges(const Shell& shell, std::span<const std::array<TriangleEdge, 2>> sides,
                                      const VectorXd& strains, AngleShare share);

/// Adds the curvature that mirrors cause: the face at a mirror has half of the change of the angle to its
/// image.
void add_mirror_curvatures(const Shell& shell, const Mirrors& mirrors, const Positions& x,
                           Eigen::Matrix3Xd& curvatures);

}  // namespace sherd
