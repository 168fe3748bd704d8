// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_obstacle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/scene_place.h"

namespace sherd {
namespace {

constexpr double concrete_young = 3e10;  // Pa, C20/25 of EN 1992-1-1: what most floors are made of
constexpr std::array<std::string_view, 4> kinds{"plane", "sphere", "box", "cylinder"};

Vector3d read_centre(TomlTable& table) {
    return table.vector("centre", "m", Vector3d::Zero());
}

PlaneShape read_plane(TomlTable& table) {
    const Vector3d point = table.vector("point", "m", Vector3d::Zero());
    return {point, read_direction(table, "normal", Vector3d::UnitZ())};
}

SphereShape read_sphere(TomlTable& table) {
    return {read_centre(table), table.number("radius", "m", positive)};
}

BoxShape read_box(TomlTable& table) {
    const Vector3d size = table.vector("size", "m");
    if ((size.array() <= 0).any()) table.report("size", "must be three positive lengths");
    return {read_centre(table), 0.5 * size};
}

CylinderShape read_cylinder(TomlTable& table) {
    const double radius = table.number("radius", "m", positive),
                 length = table.number("length", "m", positive);
    return {read_centre(table), read_direction(table, "axis", Vector3d::UnitZ()), radius, length};
}

/// What it turns about, before it is placed.
Vector3d pivot(const PlaneShape& plane) {
    return plane.point;
}

template <class Solid>
Vector3d pivot(const Solid& solid) {
    return solid.centre;
}

void read_shape(TomlTable& table, std::string_view kind, ObstacleSpec& obstacle) {
    auto geometry = table.table(kind);
    if (!geometry) return;  // reported as no table
    if (kind == "plane") obstacle.shape = read_plane(*geometry);
    if (kind == "sphere") obstacle.shape = read_sphere(*geometry);
    if (kind == "box") obstacle.shape = read_box(*geometry);
    if (kind == "cylinder") obstacle.shape = read_cylinder(*geometry);
    geometry->finish();
}

}  // namespace

ObstacleSpec read_obstacle(const std::string& name, TomlTable& table) {
    ObstacleSpec obstacle;
    obstacle.name = name;
    std::vector<std::string_view> given;
    for (const std::string_view kind : kinds)
        if (table.has(kind)) given.push_back(kind);
    if (given.empty())
        table.report("", fmt::format("needs one of {}: plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}",
                                     fmt::join(kinds, ", ")));
    for (std::size_t i = 1; i < given.size(); ++i)
        table.report(given[i], fmt::format("conflicts with {}: give one of them", given[0]));
    if (!given.empty()) {
        read_shape(table, given[0], obstacle);
        obstacle.where = table.where(given[0]);
    }
    if (auto place = table.table("place")) obstacle.motion.place = read_place(*place);
    obstacle.motion.pivot =
        obstacle.motion.place * std::visit([](const auto& shape) { return pivot(shape); }, obstacle.shape);
    read_motion(table, obstacle.motion);
    obstacle.friction = table.number("friction", "", not_negative, 0);
    obstacle.young = table.number("young", "Pa", positive, concrete_young);
    table.finish();
    return obstacle;
}

std::vector<Obstacle> make_obstacles(const Scene& scene) {
    std::vector<Obstacle> obstacles;
    for (const ObstacleSpec& spec : scene.obstacles) {
        const auto shape = std::visit(
            [](const auto& solid) -> std::shared_ptr<const Shape> {
                return std::make_shared<std::decay_t<decltype(solid)>>(solid);
            },
            spec.shape);
        obstacles.push_back({shape, spec.motion, spec.young, spec.friction});
    }
    return obstacles;
}

}  // namespace sherd
