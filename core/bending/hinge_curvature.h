// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/bending/mirror_hinge.h"

namespace sherd {

/// How the change of a hinge's angle is shared between its two faces.
enum class AngleShare {
    equal,
    by_height,  ///< over the edge, as a constant curvature across it has it
};

/// The change of curvature of each face from the angles of its own hinges alone, [3, F], 1/m, as (00, 11,
/// 2 * 01) in the face's rest frame: the sum of length / area times its share of the angle times n n^T over
/// its sides of outward normal n. Hinges that know nothing of each other know no more than that, and it does
/// not converge to the curvature of a plate (README). sides: sides_of_hinges(); strains: hinge_strain() of
/// each hinge, 1/m.
Eigen::Matrix3Xd curvatures_of_hinges(const Shell& shell, std::span<const std::array<TriangleEdge, 2>> sides,
                                      const VectorXd& strains, AngleShare share);

/// Adds what the angles to mirror images change in that: each face has half of its own.
void add_mirror_curvatures(const Shell& shell, const Mirrors& mirrors, const Positions& x,
                           Eigen::Matrix3Xd& curvatures);

}  // namespace sherd
