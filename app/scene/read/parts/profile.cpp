// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/profile.h"

#include <cmath>
#include <numbers>

namespace sherd {
namespace {

constexpr int plate_segments = 16, bowl_segments = 48;

}  // namespace

Profile plate_profile(double radius, double height, double foot) {
    const double rise_end = foot + 0.4 * (radius - foot), rise_height = 0.6 * height;
    const double width = rise_end - foot, rim_slope = (height - rise_height) / (radius - rise_end);
    Profile profile{{0, 0}};
    for (int i = 0; i <= plate_segments; ++i) {
        // Cubic Hermite curve, with slope 0 at the foot and the slope of the rim at its outer end.
        const double t = static_cast<double>(i) / plate_segments;
        const double z = rise_height * t * t * (3 - 2 * t) + width * rim_slope * t * t * (t - 1);
        profile.emplace_back(foot + width * t, z);
    }
    profile.emplace_back(radius, height);
    return profile;
}

Profile bowl_profile(double radius, double cap) {
    const double sphere = radius / std::sin(cap);
    Profile profile{{0, 0}};
    for (int i = 1; i <= bowl_segments; ++i) {
        const double angle = cap * i / bowl_segments;
        profile.emplace_back(sphere * std::sin(angle), sphere * (1 - std::cos(angle)));
    }
    return profile;
}

double revolved_area(std::span<const Eigen::Vector2d> profile) {
    double area = 0;
    for (std::size_t i = 1; i < profile.size(); ++i)
        area +=
            std::numbers::pi * (profile[i - 1].x() + profile[i].x()) * (profile[i] - profile[i - 1]).norm();
    return area;
}

double length(std::span<const Eigen::Vector2d> profile) {
    double sum = 0;
    for (std::size_t i = 1; i < profile.size(); ++i) sum += (profile[i] - profile[i - 1]).norm();
    return sum;
}

}  // namespace sherd
