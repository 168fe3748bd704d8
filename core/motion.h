// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// The pose of a moving object at one time, relative to its placement.
struct MotionKey {
    double time = 0;                          ///< s
    Vector3d translation = Vector3d::Zero();  ///< m
    Vector3d axis = Vector3d::UnitZ();        ///< unit length
    double angle = 0;  ///< rad, about the axis through the pivot; applied before the translation
};

/// Number of parts into which a motion that turns by `turn` (rad) must be divided so that points may move
/// along a straight line in each part: they are then off their arc by at most 1/128 of its radius.
int straight_parts(double turn);

/// A prescribed motion.
struct Motion {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  ///< the pose if there are no keys
    Vector3d pivot = Vector3d::Zero();                        ///< m, in the frame of the moving object
    std::vector<MotionKey> keys;                              ///< ascending in time
    /// Interpolation between two keys. true: from rest at the first to rest at the second, with the cubic 3
    /// s^2 - 2 s^3; false: at constant speed.
    bool smooth = true;

    /// The pose at `time` (s): from the frame of the object to space. The object rests before the first and
    /// after the last key. Between two keys with the same axis the angle is interpolated, over any number of
    /// turns; between keys with different axes the object takes the smallest rotation.
    Eigen::Isometry3d at(double time) const;
    /// Upper bound on the angle, rad, of the rotation between two times (s), whole turns and returns
    /// included.
    double turn_between(double from, double to) const;
};

}  // namespace sherd
