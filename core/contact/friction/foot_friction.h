// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/contact/friction/friction.h"

namespace sherd {

/// A point of a body that rubs on an obstacle or on another body.
struct SlidingFoot {
    Vector3d point;  ///< m, in the body's frame
    Vector3d other;  ///< m, of what it rubs on: on a body in its frame; on an obstacle where it is carried to
    Matrix3d tangent;
    Friction friction;
};

/// Coulomb coefficient of two things that have one each: their geometric mean, so that what is smooth slides.
inline double friction_between(double a, double b) {
    return std::sqrt(a * b);
}

}  // namespace sherd
