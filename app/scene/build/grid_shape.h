// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/shape.h"
#include "meshops/signed_distance_grid.h"

namespace sherd {

/// A shape that is given by signed distances on a grid.
struct GridShape : Shape {
    SignedDistanceGrid grid;

    explicit GridShape(SignedDistanceGrid grid) : grid(std::move(grid)) {}
    SurfaceDistance distance(const Vector3d& at) const override {
        const SignedDistanceGrid::Sample sample = grid.sample(at);
        return {sample.distance, sample.gradient, sample.hessian};
    }
    Eigen::AlignedBox3d bounds() const override { return {grid.lower(), grid.upper()}; }
};

}  // namespace sherd
