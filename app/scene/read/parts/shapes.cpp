// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/scene/read/parts/profile.h"

namespace sherd {
namespace {

using std::numbers::pi;

/// Default height and flat part of a plate, as shares of its radius. Real dinner plates of 26 cm are 2.4 cm
/// high and flat over 16 cm.
constexpr double plate_height = 0.18, plate_foot = 0.6;
constexpr Range below_180{.least = 0, .most = 180}, up_to_360{.least = 0, .most = 360, .with_most = true};
constexpr KeyRules side_rules{.unit = "m", .range = positive, .required = true};

void read_generate(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    mesh.shape = table.choice(key.name, key.rules.choices);
}

constexpr std::array<std::string_view, 8> shape_names{"rectangle", "disc", "cylinder",   "sphere",
                                                      "plate",     "bowl", "revolution", "polygon"};
constexpr std::array common_keys{
    special_key("generate", Form::choice, "the shape", {.choices = shape_names, .required = true},
                read_generate),
    key<&GeneratedMesh::edge_length>("edge_length", "target length of the edges", side_rules)};

/// Refuses `structured = true` for a shape that has no regular grid. `false`, as for other shapes, is
/// allowed.
void refuse_structured(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    // flag() makes the key a known one, which messages list, so it is called only if the table has the key.
    if (table.is_flag(key.name) && table.flag(key.name, false))
        table.report(key.name, fmt::format("is for a rectangle, a cylinder or a sector (a revolution with an "
                                           "angle below 360): there is no regular grid on a {}",
                                           mesh.shape));
}

constexpr std::array structured_key{
    key<&GeneratedMesh::structured>("structured", "a regular grid with parallel diagonals")},
    sector_structured_key{key<&GeneratedMesh::structured>(
        "structured", "for a sector, with `angle` below 360: a regular grid with parallel diagonals")},
    unstructured_key{special_key("structured", Form{}, "", {}, refuse_structured)};
constexpr std::array radius_key{key<&GeneratedMesh::radius>("radius", "its radius", side_rules)},
    width_key{key<&GeneratedMesh::width>("width", "its side along x", side_rules)},
    height_key{
        key<&GeneratedMesh::height>("height", "its side along y, or along z of a cylinder", side_rules)};

void read_plate_height(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    mesh.height = table.number(key.name, key.rules.unit, key.rules.range, plate_height * mesh.radius);
}

void read_plate_foot(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    mesh.foot = table.number(key.name, key.rules.unit, key.rules.range, plate_foot * mesh.radius);
    if (mesh.foot >= mesh.radius)
        table.report(key.name, fmt::format("must be less than radius ({} m)", mesh.radius));
}

constexpr std::array plate_part_keys{
    special_key("height", Form::number, "height of the rim above the bottom",
                {.unit = "m", .range = positive, .otherwise = "0.18 `radius`"}, read_plate_height),
    special_key("foot", Form::number, "radius of the flat bottom",
                {.unit = "m", .range = positive, .otherwise = "0.6 `radius`"}, read_plate_foot)};

void complete_plate(TomlTable& /*table*/, GeneratedMesh& mesh) {
    mesh.profile = plate_profile(mesh.radius, mesh.height, mesh.foot);
}

void read_bowl_height(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    if (table.has(key.name)) mesh.height = table.number(key.name, key.rules.unit, key.rules.range);
}

constexpr std::array bowl_part_keys{
    key<&GeneratedMesh::cap_degrees>(
        "cap_degrees", "angle from the bottom to the rim, as seen from the centre of the sphere",
        {.unit = "degrees", .range = below_180}),
    special_key(
        "height", Form::number, "height of the rim above the bottom",
        {.unit = "m", .range = positive, .otherwise = "by `cap_degrees`", .excludes = {"cap_degrees"}},
        read_bowl_height)};

void complete_bowl(TomlTable& table, GeneratedMesh& mesh) {
    const double cap =
        table.has("height") ? 2 * std::atan(mesh.height / mesh.radius) : mesh.cap_degrees * pi / 180;
    mesh.height = mesh.radius * std::tan(cap / 2);
    mesh.profile = bowl_profile(mesh.radius, cap);
}

void read_profile(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    for (const Eigen::VectorXd& point :
         table.rows(key.name, key.rules.unit, key.rules.least_rows, key.rules.columns))
        mesh.profile.emplace_back(point[0], point[1]);
}

constexpr std::array revolution_part_keys{
    special_key("profile", Form::rows,
                "`[[r, z], [r, z], ...]`, the polyline that is turned about the z axis",
                {.unit = "r, z in m", .required = true, .least_rows = 2, .columns = 2}, read_profile),
    key<&GeneratedMesh::angle>(
        "angle", "angle of the revolution; below 360 the surface is a sector that begins at the x axis",
        {.unit = "degrees", .range = up_to_360})};

void complete_revolution(TomlTable& table, GeneratedMesh& mesh) {
    const Profile& profile = mesh.profile;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const bool end = i == 0 || i + 1 == profile.size();
        if (profile[i].x() < 0 || (profile[i].x() == 0 && !end))
            table.report("profile", fmt::format("point {} has r = {}: r must be positive, or 0 at an end",
                                                i + 1, profile[i].x()));
        if (i > 0 && profile[i] == profile[i - 1])
            table.report("profile", fmt::format("points {} and {} are the same: leave one out", i, i + 1));
    }
    if (profile.empty()) return;
    if (std::ranges::all_of(profile, [](const Vector2d& p) { return p.x() == 0; }))
        table.report("profile", "lies on the axis: give a point with r > 0");
    if (mesh.structured && mesh.angle >= 360)
        table.report("structured", "is for a sector: give an angle below 360, or leave it out");
    if (mesh.angle < 360 && (profile.front().x() == 0 || profile.back().x() == 0))
        table.report("angle", "is for a profile that does not touch the axis (r > 0 everywhere)");
}

Polyline polyline(const std::vector<Eigen::VectorXd>& rows) {
    return {rows.begin(), rows.end()};
}

void read_outline(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    mesh.polygon.outline =
        polyline(table.rows(key.name, key.rules.unit, key.rules.least_rows, key.rules.columns));
}

template <std::vector<Polyline> Polygon::*member>
void read_lines(TomlTable& table, const KeyInfo& key, GeneratedMesh& mesh) {
    if (!table.has(key.name)) return;
    for (const auto& rows :
         table.lists_of_rows(key.name, key.rules.unit, key.rules.least_rows, key.rules.columns))
        (mesh.polygon.*member).push_back(polyline(rows));
}

constexpr std::array polygon_part_keys{
    special_key("outline", Form::rows, "`[[x, y], [x, y], ...]`; the last point is joined to the first",
                {.unit = "x, y in m", .required = true, .least_rows = 3, .columns = 2}, read_outline),
    special_key("holes", Form::lists_of_rows, "outlines of holes",
                {.unit = "x, y in m", .otherwise = "none", .least_rows = 3, .columns = 2},
                read_lines<&Polygon::holes>),
    special_key("slits", Form::lists_of_rows, "lines along which the sheet is open from the start",
                {.unit = "x, y in m", .otherwise = "none", .least_rows = 2, .columns = 2},
                read_lines<&Polygon::slits>)};

void complete_polygon(TomlTable& table, GeneratedMesh& mesh) {
    if (mesh.polygon.outline.empty()) return;
    if (const auto fault = fault_of(mesh.polygon)) table.report(fault->part, fault->what);
}

constexpr auto rectangle_keys = joined(common_keys, structured_key, width_key, height_key);
constexpr auto round_keys = joined(common_keys, unstructured_key, radius_key);
constexpr auto tube_keys = joined(common_keys, structured_key, radius_key, height_key);
constexpr auto plate_keys = joined(common_keys, unstructured_key, radius_key, plate_part_keys);
constexpr auto bowl_keys = joined(common_keys, unstructured_key, radius_key, bowl_part_keys);
constexpr auto revolution_keys = joined(common_keys, sector_structured_key, revolution_part_keys);
constexpr auto polygon_keys = joined(common_keys, unstructured_key, polygon_part_keys);

using ShapeSection = Section<GeneratedMesh>;
/// Sections in the order of shape_names.
constexpr std::array<ShapeSection, shape_names.size()> shapes{
    ShapeSection{"A rectangle from the origin along x and y, z = 0", rectangle_keys},
    ShapeSection{"A disc about the origin, z = 0", round_keys},
    ShapeSection{"An open tube about the z axis, from z = 0 upward", tube_keys},
    ShapeSection{"A closed sphere about the origin", round_keys},
    ShapeSection{"A dinner plate, its bottom at z = 0", plate_keys, complete_plate},
    ShapeSection{"A bowl: the cap of a sphere, its bottom at z = 0", bowl_keys, complete_bowl},
    ShapeSection{"A surface of revolution about the z axis", revolution_keys, complete_revolution},
    ShapeSection{"A polygon in the plane z = 0", polygon_keys, complete_polygon}};

double smaller_side(const Polyline& line) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : line) box.extend(p);
    return box.sizes().minCoeff();
}

/// Returns the area (m^2) of a shape, and the smallest of its sizes (m), which the edge length must not
/// exceed.
std::pair<double, double> area_and_size(const GeneratedMesh& mesh) {
    const double r = mesh.radius;
    if (mesh.shape == "rectangle") return {mesh.width * mesh.height, std::min(mesh.width, mesh.height)};
    if (mesh.shape == "disc") return {pi * r * r, r};
    if (mesh.shape == "cylinder") return {2 * pi * r * mesh.height, std::min(r, mesh.height)};
    if (mesh.shape == "sphere") return {4 * pi * r * r, r};
    if (mesh.shape == "polygon" && mesh.polygon.outline.empty())
        return {0, std::numeric_limits<double>::infinity()};
    if (mesh.shape == "polygon") return {area(mesh.polygon), smaller_side(mesh.polygon.outline)};
    return {revolved_area(mesh.profile) * mesh.angle / 360, length(mesh.profile)};
}

void check_edge_length(TomlTable& table, const GeneratedMesh& mesh) {
    const auto [area, size] = area_and_size(mesh);
    if (mesh.edge_length > size)
        table.report("edge_length",
                     fmt::format("is larger than the {} ({:.3g} m): give a smaller one", mesh.shape, size));
    const double faces = expected_faces(area, mesh.edge_length);
    if (faces > most_faces)
        table.report("edge_length",
                     fmt::format("would make about {:.2g} faces, more than {:.0g}: give a larger one", faces,
                                 most_faces));
}

}  // namespace

void read_shape(TomlTable& table, GeneratedMesh& mesh) {
    const std::string name = table.choice("generate", shape_names);
    const auto found = std::ranges::find(shape_names, name);
    if (found == shape_names.end()) return;
    read_keys(table, shapes[static_cast<std::size_t>(found - shape_names.begin())], mesh);
    check_edge_length(table, mesh);
    table.finish();
}

std::vector<SectionText> inside_shapes() {
    std::vector<SectionText> texts;
    for (const ShapeSection& shape : shapes) {
        SectionText& text = texts.emplace_back(text_of(shape));
        text.keys.front().info.rules.choices = std::span(shape_names).subspan(texts.size() - 1, 1);
    }
    return texts;
}

}  // namespace sherd
