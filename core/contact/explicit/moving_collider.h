// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/vector.h"

namespace sherd {

/// Velocity, m/s, of the point `at` (m, at the end) of a rigid collider that moves from one pose to another
/// in `length` s.
inline Vector3d velocity_of_point(const Eigen::Isometry3d& before, const Eigen::Isometry3d& now,
                                  const Vector3d& at, double length) {
    return (at - before * (now.inverse() * at)) / length;
}

}  // namespace sherd
