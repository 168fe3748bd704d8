// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/bending/mirror_hinge.h"

namespace sherd {

/// Division of the change of a hinge's angle between its two faces.
enum class AngleShare {
    equal,
    by_height,  ///< by height over the edge, as for a constant curvature across it
};

/// The part of a side in the curvature of its face: see curvatures_of_hinges(). rest: of its hinge; strain:
/// hinge_strain(), 1/m.
Vector3d curvature_of_hinge(const RestHinge& rest, const MembraneTriangle& face, int corner, double strain,
                            AngleShare share);

/// The change of curvature of each face from the angles of its own hinges alone, [3, F], 1/m, as (00, 11,
/// 2 * 01) in the face's rest frame: the sum of length / area times its share of the angle times n n^T over
/// its sides of outward normal n. Uncoupled hinges determine no more than this, and it does not converge to
/// the curvature of a plate (docs/theory/bending.md). sides: sides_of_hinges(); strains: hinge_strain() of
/// each hinge, 1/m.
Eigen::Matrix3Xd curvatures_of_hinges(const Shell& shell, std::span<const std::array<TriangleEdge, 2>> sides,
                                      const VectorXd& strains, AngleShare share);

/// Adds the changes of the angles to mirror images: each face has half of its own.
void add_mirror_curvatures(const Shell& shell, const Mirrors& mirrors, const Positions& x,
                           Eigen::Matrix3Xd& curvatures);

}  // namespace sherd
