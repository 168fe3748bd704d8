// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// The pose of something in motion at one time, relative to where it was placed.
struct MotionKey {
    double time = 0;                          ///< s
    Vector3d translation = Vector3d::Zero();  ///< m
    Vector3d axis = Vector3d::UnitZ();        ///< unit length
    double angle = 0;  ///< rad about the axis through the pivot; applied before the translation
};

/// The number of parts of a motion that turns by `turn`, rad, in which points may go straight: they are then
/// off their arc by at most 1/128 of its radius.
int straight_parts(double turn);

/// A scripted motion.
struct Motion {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  ///< the pose if there are no keys
    Vector3d pivot = Vector3d::Zero();                        ///< m, in the frame of the thing that moves
    std::vector<MotionKey> keys;                              ///< ascending in time
    /// Interpolation between keys: true: from rest to rest, with the cubic 3 s^2 - 2 s^3; false: at constant
    /// speed.
    bool smooth = true;

    /// The pose at `time` (s): from the frame of the thing to space. It rests before the first and after the
    /// last key. Between two keys with the same axis the angle is interpolated, over any number of turns;
    /// otherwise the rotation takes the shortest way.
    Eigen::Isometry3d at(double time) const;
    /// No less than the angle, rad, by which it turns between two times, whole turns and ways back included.
    double turn_between(double from, double to) const;
};

}  // namespace sherd
