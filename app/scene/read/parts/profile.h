// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sherd {

/// Polyline of points (r, z), m, from the axis outward, which is revolved about the z axis.
using Profile = std::vector<Eigen::Vector2d>;

/// Returns the profile of a dinner plate: it is flat from the axis to `foot`, then rises in a curve to three
/// fifths of `height`, and ends in a rim that slopes gently to `radius` and `height`, without a kink. All
/// parameters are in m, and 0 < foot < radius.
Profile plate_profile(double radius, double height, double foot);

/// Returns the profile of a bowl, a cap of a sphere. radius: m, of the rim; cap: rad, angle from the bottom
/// to the rim as seen from the centre of the sphere, 0 < cap < pi.
Profile bowl_profile(double radius, double cap);

/// Returns the area of the surface of revolution of a profile (m^2), by Pappus's theorem.
double revolved_area(std::span<const Eigen::Vector2d> profile);

/// Returns the length of the polyline (m).
double length(std::span<const Eigen::Vector2d> profile);

}  // namespace sherd
