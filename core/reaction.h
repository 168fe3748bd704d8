// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/vector.h"

namespace sherd {

/// Force and moment of a support or an obstacle on the sheets and bodies that it holds or touches.
struct Reaction {
    Vector3d force = Vector3d::Zero();   ///< N
    Vector3d moment = Vector3d::Zero();  ///< N m, about the origin

    /// Adds the force `of_point` (N), which acts on the point `at` (m).
    void add(const Vector3d& at, const Vector3d& of_point) {
        force += of_point;
        moment += at.cross(of_point);
    }
};

}  // namespace sherd
