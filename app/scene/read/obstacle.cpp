// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/obstacle.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/read/parts/mesh_spec.h"
#include "app/scene/read/parts/place.h"

namespace sherd {
namespace {

constexpr KeyRules length_rules{.unit = "m", .range = positive, .required = true};

constexpr std::array plane_keys{
    key<&PlaneShape::point>("point", "a point of the plane", {.unit = "m"}),
    direction_key<&PlaneShape::normal>("normal",
                                       "normal of the plane; sheets stay on the side to which it points")};
constexpr Section<PlaneShape> plane_section{"A plane", plane_keys};

constexpr std::array sphere_keys{key<&SphereShape::radius>("radius", "its radius", length_rules),
                                 key<&SphereShape::centre>("centre", "its centre", {.unit = "m"})};
constexpr Section<SphereShape> sphere_section{"A sphere", sphere_keys};

void read_box_size(TomlTable& table, const KeyInfo& key, BoxShape& box) {
    const Vector3d size = table.vector(key.name, key.rules.unit);
    if ((size.array() <= 0).any()) table.report(key.name, "must be three positive lengths");
    box.half = 0.5 * size;
}

constexpr std::array box_keys{special_key("size", Form::vector, "lengths of its sides along the axes",
                                          {.unit = "m", .required = true}, read_box_size),
                              key<&BoxShape::centre>("centre", "its centre", {.unit = "m"})};
constexpr Section<BoxShape> box_section{"A box", box_keys};

constexpr std::array cylinder_keys{
    key<&CylinderShape::radius>("radius", "its radius", length_rules),
    key<&CylinderShape::length>("length", "length between its flat ends", length_rules),
    key<&CylinderShape::centre>("centre", "its centre", {.unit = "m"}),
    direction_key<&CylinderShape::axis>("axis", "direction of its axis")};
constexpr Section<CylinderShape> cylinder_section{"A cylinder", cylinder_keys};

constexpr std::array voxel_key{key<&ObstacleMesh::voxel>(
    "voxel", "voxel size of the signed distance grid into which the mesh is converted",
    {.unit = "m", .range = positive, .otherwise = "a hundredth of the mesh's diagonal, 0.02 mm at least"})};
constexpr auto mesh_keys = joined(embedded<mesh_file_keys, &ObstacleMesh::file>(), voxel_key);
constexpr Section<ObstacleMesh> mesh_section{"A mesh from a file", mesh_keys};

constexpr std::array level_set_keys{
    key<&ObstacleLevelSet::path>("file", "an OpenVDB file",
                                 {.what = "the name of an OpenVDB file", .required = true}),
    key<&ObstacleLevelSet::name>(
        "grid", "name of the grid",
        {.what = "the name of a level set in the file", .otherwise = "the only float grid"}),
    key<&ObstacleLevelSet::scale>("scale", "metres per unit of the file",
                                  {.unit = "m per unit of the file", .range = positive})};
constexpr Section<ObstacleLevelSet> level_set_section{"A level set", level_set_keys};

/// Reads the shape of an obstacle, unless an earlier key has given one.
template <const auto& section>
void read_solid(TomlTable& table, const KeyInfo& key, ObstacleSpec& obstacle) {
    if (!table.has(key.name) || !obstacle.where.empty()) return;
    using Shape = typename std::remove_cvref_t<decltype(section)>::Struct;
    obstacle.where = table.where(key.name);
    Shape& shape = obstacle.shape.emplace<Shape>();
    if constexpr (std::is_same_v<Shape, ObstacleMesh>)
        if (table.is_string(key.name)) return void(shape.file.path = table.file(key.name, key.rules.what));
    if constexpr (std::is_same_v<Shape, ObstacleLevelSet>)
        if (table.is_string(key.name)) return void(shape.path = table.file(key.name, key.rules.what));
    keys::read_table(table, key, section, shape);
}

template <const auto& section>
constexpr auto solid_key(std::string_view name, Form forms, std::string_view sentence,
                         const KeyRules& rules) {
    return special_key(name, forms, sentence, rules, read_solid<section>,
                       [] { return std::vector{text_of(section)}; });
}

constexpr std::array solid_keys{
    solid_key<plane_section>("plane", Form::table, "a half-space", {}),
    solid_key<sphere_section>("sphere", Form::table, "a ball", {.excludes = {"plane"}}),
    solid_key<box_section>("box", Form::table, "a box with sides along the axes",
                           {.excludes = {"plane", "sphere"}}),
    solid_key<cylinder_section>("cylinder", Form::table, "a cylinder with flat ends",
                                {.excludes = {"plane", "sphere", "box"}}),
    solid_key<mesh_section>(
        "mesh", Form::file | Form::table, "a closed mesh; with `cache`, any mesh",
        {.what = "the name of a file", .excludes = {"plane", "sphere", "box", "cylinder"}}),
    solid_key<level_set_section>(
        "vdb", Form::file | Form::table, "a level set of an OpenVDB file",
        {.what = "the name of a file", .excludes = {"plane", "sphere", "box", "cylinder", "mesh"}})};

constexpr std::array<std::string_view, 2> interpolations_of_caches{"cardinal", "linear"};
constexpr std::array cache_keys{
    key<&ObstacleCache::path>("file", "a point cache",
                              {.what = "the name of a .pc2 or .mdd file", .required = true}),
    key<&ObstacleCache::start>("start", "time of the first sample, whatever time the file begins with",
                               {.unit = "s"}),
    key<&ObstacleCache::frame_rate>(
        "fps", "frames per second of a `.pc2`, samples per second of an `.mdd`",
        {.unit = "1/s", .range = positive, .otherwise = "24 for `.pc2`, the times in the file for `.mdd`"}),
    key<&ObstacleCache::smooth>("interpolation",
                                "motion between samples: with a continuous velocity, or at constant speed",
                                {.choices = interpolations_of_caches})};
constexpr Section<ObstacleCache> cache_section{"A point cache", cache_keys};

/// Reads `cache`, and reports keys that conflict with it.
void read_cache(TomlTable& table, const KeyInfo& key, ObstacleSpec& obstacle) {
    if (!table.has(key.name)) return;
    auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape);
    if (mesh == nullptr) return table.report(key.name, "is for a mesh, whose vertices it moves");
    for (const char* other : {"density", "mass"})
        if (table.has(other))
            table.report(key.name, fmt::format("conflicts with {}: a free body is rigid", other));
    if (mesh->voxel > 0 || mesh->file.join || !mesh->file.repair)
        table.report(key.name,
                     "takes the mesh as it is in the file, whose vertices are those of the cache: "
                     "leave out voxel, join and repair");
    ObstacleCache& cache = mesh->cache.emplace();
    cache.where = table.where(key.name);
    if (table.is_string(key.name))
        cache.path = table.file(key.name, key.rules.what);
    else
        keys::read_table(table, key, cache_section, cache);
}

std::vector<SectionText> inside_cache() {
    return {text_of(cache_section)};
}

/// Returns the free motion of an obstacle, and makes the obstacle a free body if it is none yet.
FreeMotion& free_motion(ObstacleSpec& obstacle) {
    return obstacle.free ? *obstacle.free : obstacle.free.emplace();
}

template <double FreeMotion::*member>
void read_inertia(TomlTable& table, const KeyInfo& key, ObstacleSpec& obstacle) {
    if (table.has(key.name))
        free_motion(obstacle).*member = table.number(key.name, key.rules.unit, key.rules.range);
}

template <Vector3d FreeMotion::*member>
void read_start(TomlTable& table, const KeyInfo& key, ObstacleSpec& obstacle) {
    if (obstacle.free)
        obstacle.free.value().*member = table.vector(key.name, key.rules.unit, Vector3d::Zero());
    else if (table.has(key.name))
        table.report(key.name, "needs density or mass: only a free body has it");
}

double volume(const ObstacleSpec& obstacle) {
    if (const auto* sphere = std::get_if<SphereShape>(&obstacle.shape))
        return 4.0 / 3 * std::numbers::pi * std::pow(sphere->radius, 3);
    const auto* box = std::get_if<BoxShape>(&obstacle.shape);
    return box ? 8 * box->half.prod() : 0;
}

void complete_free_motion(TomlTable& table, ObstacleSpec& obstacle) {
    if (!obstacle.free) return;
    const bool has_mass = table.has("mass"), is_mesh = std::holds_alternative<ObstacleMesh>(obstacle.shape);
    const char* key = has_mass ? "mass" : "density";
    if (!is_mesh && volume(obstacle) == 0)
        table.report(key, "is for a sphere, a box or a mesh: only these can be free bodies");
    if (!obstacle.motion.keys.empty()) table.report(key, "conflicts with keys: a free body moves by itself");
    if (has_mass && !is_mesh) obstacle.free->density = obstacle.free->mass / volume(obstacle);
}

/// Returns the point, m, about which an obstacle rotates, before the obstacle is placed: a point of a plane,
/// the centre of a sphere, box or cylinder, the origin of a mesh or level set.
template <class Kind>
Vector3d pivot(const Kind& kind) {
    if constexpr (requires { kind.point; }) return kind.point;
    if constexpr (requires { kind.centre; }) return kind.centre;
    return Vector3d::Zero();
}

void complete_obstacle(TomlTable& table, ObstacleSpec& obstacle) {
    if (obstacle.where.empty()) {
        std::vector<std::string_view> kinds;
        for (const auto& solid : solid_keys) kinds.push_back(solid.info.name);
        table.report("", fmt::format("needs one of {}: plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}",
                                     fmt::join(kinds, ", ")));
    }
    obstacle.motion.pivot =
        obstacle.motion.place * std::visit([](const auto& shape) { return pivot(shape); }, obstacle.shape);
    check_motion(table, obstacle.motion);
    complete_free_motion(table, obstacle);
}

constexpr auto obstacle_keys = joined(
    solid_keys,
    std::array{table_key<place_section, &ObstacleSpec::motion, &Motion::place>(
        "place", "rotation and translation of the obstacle", {.otherwise = "none"})},
    embedded<motion_keys, &ObstacleSpec::motion>(),
    std::array{
        special_key("cache", Form::file | Form::table, "for a `mesh`: a point cache that deforms it",
                    {.what = "the name of a .pc2 or .mdd file", .otherwise = "rigid"}, read_cache,
                    inside_cache),
        special_key("mass", Form::number, "for a `sphere`, a `box` or a `mesh`: makes it a free rigid body",
                    {.unit = "kg", .range = positive, .otherwise = "fixed"}, read_inertia<&FreeMotion::mass>),
        special_key("density", Form::number, "instead of `mass`",
                    {.unit = "kg/m^3", .range = positive, .otherwise = "fixed", .excludes = {"mass"}},
                    read_inertia<&FreeMotion::density>),
        special_key("velocity", Form::vector, "velocity of a free body at the start",
                    {.unit = "m/s", .otherwise = "`[0, 0, 0]`"}, read_start<&FreeMotion::velocity>),
        special_key("spin", Form::vector,
                    "angular velocity of a free body at the start, about its centre of mass",
                    {.unit = "rad/s", .otherwise = "`[0, 0, 0]`"}, read_start<&FreeMotion::spin>),
        key<&ObstacleSpec::friction>("friction", "coefficient of Coulomb friction", {.range = not_negative}),
        key<&ObstacleSpec::young>("young", "Young's modulus of the obstacle; the default is that of concrete",
                                  {.unit = "Pa", .range = positive})});

}  // namespace

constinit const Section<ObstacleSpec> obstacle_section{"An obstacle, which sheets cannot pass through",
                                                       obstacle_keys, complete_obstacle};

bool has_shape(TomlTable& table) {
    bool found = false;
    // Each key is asked for, so that messages list the keys in their order.
    for (const Key<ObstacleSpec>& key : solid_keys) found |= table.has(key.info.name);
    return found;
}

}  // namespace sherd
