// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

// Strain and stress of a triangle, or of four at once with Lanes as Real.

/// Green strain (00, 11, 2 * 01) of a deformation gradient.
template <class Real>
Eigen::Matrix<Real, 3, 1> strain_of(const Eigen::Matrix<Real, 3, 2>& F) {
    return {0.5 * (F.col(0).squaredNorm() - 1), 0.5 * (F.col(1).squaredNorm() - 1), F.col(0).dot(F.col(1))};
}

/// The first Piola-Kirchhoff stress F S. stress: the second Piola-Kirchhoff stress S, (00, 11, 01).
template <class Real>
Eigen::Matrix<Real, 3, 2> pulled(const Eigen::Matrix<Real, 3, 2>& F,
                                 const Eigen::Matrix<Real, 3, 1>& stress) {
    Eigen::Matrix<Real, 3, 2> P;
    P.col(0) = stress[0] * F.col(0) + stress[2] * F.col(1);
    P.col(1) = stress[2] * F.col(0) + stress[1] * F.col(1);
    return P;
}

}  // namespace sherd
