// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Where something that moves is at one time, from where it was placed on.
struct MotionKey {
    double time = 0;                          ///< s
    Vector3d translation = Vector3d::Zero();  ///< m
    Vector3d axis = Vector3d::UnitZ();        ///< unit length
    double angle = 0;  ///< rad about the axis through the pivot, before the translation
};

/// A motion that is known beforehand.
struct Motion {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  ///< without keys, for good
    Vector3d pivot = Vector3d::Zero();                        ///< m, as placed
    std::vector<MotionKey> keys;                              ///< ascending in time
    /// From key to key: true: from rest to rest, with the cubic 3 s^2 - 2 s^3; false: at constant speed.
    bool smooth = true;

    /// From the frame of the thing to space. Before the first and after the last key it rests. Between two
    /// keys with one axis the angle is interpolated, over any number of turns; between others the rotation
    /// takes the shortest way.
    Eigen::Isometry3d at(double time) const;
};

}  // namespace sherd
