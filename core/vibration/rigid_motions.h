// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/block_matrix.h"
#include "core/shell/shell.h"

namespace sherd {

/// Product of the matrix with a vector x, [size()].
VectorXd product(const BlockMatrix& matrix, const VectorXd& x);

/// The rigid motions of connected pieces of the shell, from x [3, V] m, that supports leave free and the
/// stiffness (N/m) does not resist, as columns sqrt(m) u, orthonormal: [3 V, 0 to 6 for each piece]. A motion
/// is free if the stiffness against it is within round-off of the largest stiffness. fastest: 1/s^2, about
/// the square of the highest angular frequency.
Eigen::MatrixXd free_rigid_motions(const Shell& shell, const Positions& x, const BlockMatrix& stiffness,
                                   double fastest);

}  // namespace sherd
