// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/obstacle.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/scene/read/mesh_spec.h"
#include "app/scene/read/place.h"

namespace sherd {
namespace {

constexpr double concrete_young = 3e10;  // Pa, C20/25 of EN 1992-1-1: what most floors are made of
constexpr std::array<std::string_view, 6> kinds{"plane", "sphere", "box", "cylinder", "mesh", "vdb"};

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

ObstacleMesh read_obstacle_mesh(TomlTable& table, const std::filesystem::path& directory) {
    ObstacleMesh mesh;
    mesh.file = read_mesh_file(table, directory);
    if (table.has("voxel")) mesh.voxel = table.number("voxel", "m", positive);
    return mesh;
}

ObstacleLevelSet read_level_set(TomlTable& table, const std::filesystem::path& directory) {
    ObstacleLevelSet level_set;
    level_set.path = directory / table.string("file", "the name of an OpenVDB file");
    if (table.has("grid")) level_set.name = table.string("grid", "the name of a level set in the file");
    level_set.scale = table.number("scale", "m per unit of the file", positive, 1);
    return level_set;
}

/// What it turns about, before it is placed: a solid about its centre, files about their origin.
template <class Kind>
Vector3d pivot(const Kind& kind) {
    if constexpr (requires { kind.point; }) return kind.point;
    if constexpr (requires { kind.centre; }) return kind.centre;
    return Vector3d::Zero();
}

/// `mesh = "anvil.obj"` and `vdb = "anvil.vdb"`; false when it is a table.
bool read_file_name(TomlTable& table, std::string_view kind, const std::filesystem::path& directory,
                    ObstacleSpec& obstacle) {
    if (!table.is_string(kind) || (kind != "mesh" && kind != "vdb")) return false;
    const std::filesystem::path path = directory / table.string(kind, "the name of a file");
    if (kind == "mesh") obstacle.shape = ObstacleMesh{.file = {.path = path, .remesh = {}}};
    if (kind == "vdb") obstacle.shape = ObstacleLevelSet{.path = path, .name = ""};
    return true;
}

void read_shape(TomlTable& table, std::string_view kind, const std::filesystem::path& directory,
                ObstacleSpec& obstacle) {
    if (read_file_name(table, kind, directory, obstacle)) return;
    auto geometry = table.table(kind);
    if (!geometry) return;  // reported as no table
    if (kind == "plane") obstacle.shape = read_plane(*geometry);
    if (kind == "sphere") obstacle.shape = read_sphere(*geometry);
    if (kind == "box") obstacle.shape = read_box(*geometry);
    if (kind == "cylinder") obstacle.shape = read_cylinder(*geometry);
    if (kind == "mesh") obstacle.shape = read_obstacle_mesh(*geometry, directory);
    if (kind == "vdb") obstacle.shape = read_level_set(*geometry, directory);
    geometry->finish();
}

/// `cache = "hand.pc2"` or `cache = { file = "hand.pc2", start = 0, fps = 24, interpolation = "cardinal" }`.
ObstacleCache read_cache(TomlTable& table, const std::filesystem::path& directory) {
    ObstacleCache cache{.path = {}, .where = table.where("cache")};
    constexpr const char* what = "the name of a .pc2 or .mdd file";
    if (table.is_string("cache")) {
        cache.path = directory / table.string("cache", what);
        return cache;
    }
    auto keys = table.table("cache");
    if (!keys) return cache;  // reported as no table
    cache.path = directory / keys->string("file", what);
    cache.start = keys->number("start", "s", any_number, 0);
    if (keys->has("fps")) cache.frame_rate = keys->number("fps", "1/s", positive);
    if (keys->has("interpolation")) {
        constexpr std::array<std::string_view, 2> kinds{"cardinal", "linear"};
        cache.smooth = keys->choice("interpolation", kinds) != "linear";
    }
    keys->finish();
    return cache;
}

/// Reads `cache`, and what does not go with it.
void read_deformation(TomlTable& table, const std::filesystem::path& directory, ObstacleSpec& obstacle) {
    if (!table.has("cache")) return;
    auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape);
    if (mesh == nullptr) return table.report("cache", "is for a mesh, whose vertices it moves");
    for (const char* key : {"density", "mass"})
        if (table.has(key))
            table.report("cache", fmt::format("conflicts with {}: a free body is rigid", key));
    if (mesh->voxel > 0 || mesh->file.join || !mesh->file.repair)
        table.report("cache",
                     "takes the mesh as it is in the file, whose vertices are those of the cache: "
                     "leave out voxel, join and repair");
    mesh->cache = read_cache(table, directory);
}

double volume(const ObstacleSpec& obstacle) {
    if (const auto* sphere = std::get_if<SphereShape>(&obstacle.shape))
        return 4.0 / 3 * std::numbers::pi * std::pow(sphere->radius, 3);
    const auto* box = std::get_if<BoxShape>(&obstacle.shape);
    return box ? 8 * box->half.prod() : 0;
}

/// Reads `density` or `mass`, which make an obstacle a free body, and what only such a body has.
void read_free_motion(TomlTable& table, ObstacleSpec& obstacle) {
    const bool has_mass = table.has("mass"), has_density = table.has("density");
    if (!has_mass && !has_density) {
        for (const char* key : {"velocity", "spin"})
            if (table.has(key)) table.report(key, "needs density or mass: only a free body has it");
        return;
    }
    const char* key = has_mass ? "mass" : "density";
    if (has_mass && has_density) table.report("density", "conflicts with mass: give one of them");
    const bool is_mesh = std::holds_alternative<ObstacleMesh>(obstacle.shape);
    if (!is_mesh && volume(obstacle) == 0)
        table.report(key, "makes a free body of a sphere, a box or a mesh only");
    if (!obstacle.motion.keys.empty()) table.report(key, "conflicts with keys: a free body moves by itself");
    FreeMotion& free = obstacle.free.emplace();
    if (has_mass) free.mass = table.number("mass", "kg", positive);
    if (has_density) free.density = table.number("density", "kg/m^3", positive);
    if (has_mass && !is_mesh) free.density = free.mass / volume(obstacle);
    free.velocity = table.vector("velocity", "m/s", Vector3d::Zero());
    free.spin = table.vector("spin", "rad/s", Vector3d::Zero());
}

}  // namespace

ObstacleSpec read_obstacle(const std::string& name, TomlTable& table,
                           const std::filesystem::path& directory) {
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
        read_shape(table, given[0], directory, obstacle);
        obstacle.where = table.where(given[0]);
    }
    if (auto place = table.table("place")) obstacle.motion.place = read_place(*place);
    obstacle.motion.pivot =
        obstacle.motion.place * std::visit([](const auto& shape) { return pivot(shape); }, obstacle.shape);
    read_motion(table, obstacle.motion);
    read_deformation(table, directory, obstacle);
    read_free_motion(table, obstacle);
    obstacle.friction = table.number("friction", "", not_negative, 0);
    obstacle.young = table.number("young", "Pa", positive, concrete_young);
    table.finish();
    return obstacle;
}

}  // namespace sherd
