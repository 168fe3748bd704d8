// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sherd {

/// Polyline of (r, z) points in m, from the axis outward, that is turned about the z axis.
using Profile = std::vector<Eigen::Vector2d>;

/// Returns the profile of a dinner plate: it is flat from the axis to `foot`, then rises in a curve to three
/// fifths of `height`, and its rim slopes gently on to `radius`, without a kink. All are in m, and 0 < foot <
/// radius.
Profile plate_profile(double radius, double height, double foot);

/// Returns the profile of a bowl: the cap of a sphere, `cap` radians from its bottom to its rim of `radius`
/// (m). 0 < cap < pi.
Profile bowl_profile(double radius, double cap);

/// Returns the area of the surface of revolution (m^2), by Pappus.
double revolved_area(std::span<const Eigen::Vector2d> profile);

/// Returns the length of the polyline (m).
double length(std::span<const Eigen::Vector2d> profile);

}  // namespace sherd
