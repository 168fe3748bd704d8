// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/bending/fold_tree.h"

namespace sherd {

/// The bending energy of one face of coupled hinges as a polynomial of the positions x [N, 3] of the vertices
/// of its tree (FoldTree),
///     E = 1/2 sum_c x_c^T Q x_c - sum_j k_j [e0, e1, e2]_j + constant       c: x, y, z; j: joints.
/// It is the cubic shell (paper, eq. 7) carried over from one hinge to several that know each other: at rest
/// it is zero and in equilibrium, and as long as no triangle changes its shape, its second derivatives there
/// are those of 1/2 dtheta^T S dtheta in the true angles of the joints.
struct CubicFace {
    Eigen::MatrixXd quadratic;  ///< Q, N/m, [N, N], the same for x, y and z; rows sum to zero
    VectorXd cubic;             ///< k of each joint, N/m^2
    double constant = 0;        ///< J
};

/// rest: [3, N] m, of the tree's vertices. stiffness: S, N m, by joints. Nothing where there is none that is
/// exact to round-off and hardly stiffer than S: where triangles around the face are at angles of 60 degrees
/// and more to each other.
std::optional<CubicFace> cubic_face(const FoldTree& tree, const Positions& rest,
                                    const Eigen::MatrixXd& stiffness);

}  // namespace sherd
