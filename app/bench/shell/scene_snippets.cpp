// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/scene_snippets.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace sherd {

std::string box(const Vector3d& lower, const Vector3d& upper) {
    return fmt::format("[[{}, {}, {}], [{}, {}, {}]]", lower.x(), lower.y(), lower.z(), upper.x(), upper.y(),
                       upper.z());
}

std::string box_at(const Vector3d& p) {
    const Vector3d near = Vector3d::Constant(1e-6);
    return box(p - near, p + near);
}

std::string force_at(const Vector3d& p, const Vector3d& force) {
    return fmt::format("[[force.load]]\npoint = [{}, {}, {}]\nbox = {}\n", force.x(), force.y(), force.z(),
                       box_at(p));
}

std::string gauge_at(const std::string& name, const Vector3d& p) {
    return fmt::format("[[gauge]]\nname = \"{}\"\nat = [{}, {}, {}]\n", name, p.x(), p.y(), p.z());
}

std::string material(double thickness, double young, double poisson) {
    return fmt::format("material = {{ density = 1, thickness = {}, young = {}, poisson = {} }}\n", thickness,
                       young, poisson);
}

double young_of_unit_plate(double poisson) {
    return 12 * (1 - poisson * poisson) / std::pow(plate_thickness, 3);
}

std::string unit_plate(double poisson) {
    return material(plate_thickness, young_of_unit_plate(poisson), poisson);
}

std::string rectangle(double width, double height) {
    return fmt::format("mesh = {{ generate = \"rectangle\", width = {}, height = {}, MESH }}\n", width,
                       height);
}

std::string revolution(const std::string& profile, double angle) {
    return fmt::format("mesh = {{ generate = \"revolution\", profile = {}, angle = {}, MESH }}\n", profile,
                       angle);
}

std::string line(double r0, double z0, double r1, double z1) {
    return fmt::format("[[{}, {}], [{}, {}]]", r0, z0, r1, z1);
}

/// The polyline has so many points that even on the finest mesh its difference from a circle does not matter.
std::string arc(double radius, double from_degrees, double to_degrees) {
    constexpr int pieces = 200;
    std::string points;
    for (int i = 0; i <= pieces; ++i) {
        const double angle =
            (from_degrees + (to_degrees - from_degrees) * i / pieces) * std::numbers::pi / 180;
        points +=
            fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", radius * std::sin(angle), radius * std::cos(angle));
    }
    return "[" + points + "]";
}

}  // namespace sherd
