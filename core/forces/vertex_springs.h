// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/element_energy.h"

namespace sherd {

/// Springs of zero rest length from each vertex, or each column from `first` on, to an anchor.
struct VertexSprings {
    VectorXd stiffness;  ///< [V] N/m
    Positions anchor;    ///< [3, V] m
    Index first = 0;

    std::size_t size() const { return static_cast<std::size_t>(anchor.cols()); }
    std::array<Index, 1> vertices(std::size_t i) const { return {first + static_cast<Index>(i)}; }
    double value(std::size_t i, const Vector3d& x) const {
        return 0.5 * stiffness[i] * (x - anchor.col(i)).squaredNorm();
    }
    Vector3d gradient(std::size_t i, const Vector3d& x) const { return (x - anchor.col(i)) * stiffness[i]; }
    Matrix3d hessian(std::size_t i, const Vector3d&, Curvature) const {
        return stiffness[i] * Matrix3d::Identity();
    }
};

}  // namespace sherd
