// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/mesh_spec.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/scene/read/profile.h"
#include "meshops/error.h"
#include "meshops/polygon_soup.h"

namespace sherd {
namespace {

using std::numbers::pi;

constexpr std::array<std::string_view, 8> shapes{"rectangle", "disc", "cylinder",   "sphere",
                                                 "plate",     "bowl", "revolution", "polygon"};
/// Of real dinner plates, of 26 cm and 2.4 cm high with a flat of 16 cm, as parts of the radius.
constexpr double plate_height = 0.18, plate_foot = 0.6;
constexpr double bowl_cap = 60;  // degrees
constexpr Range cap_degrees{[](double x) { return x > 0 && x < 180; }, "a number between 0 and 180"};

constexpr Range sector_degrees{[](double x) { return x > 0 && x <= 360; },
                               "a number above 0, and 360 at most"};

/// Largest side of the bounding box of what the file's polygons use, in units of the file; 0 if it cannot be
/// read: then whoever makes the mesh says why.
double extent_of(const std::filesystem::path& file) try {
    const PolygonSoup soup = read_polygon_soup(file);
    check_polygon_soup(soup);
    Eigen::AlignedBox3d box;
    for (const auto& corners : soup.polygons)
        for (const std::size_t corner : corners)
            box.extend(Vector3d(soup.points[corner].x(), soup.points[corner].y(), soup.points[corner].z()));
    return box.sizes().maxCoeff();
} catch (const Error&) {
    return 0;
}

/// Reads `size` and makes a scale of it.
void read_size(TomlTable& table, MeshFile& mesh) {
    if (table.has("scale")) table.report("size", "conflicts with scale: give one of them");
    const double size = table.number("size", "m, the largest extent", positive);
    if (const double extent = extent_of(mesh.path); extent > 0) mesh.scale = size / extent;
}

double length_of(TomlTable& table, std::string_view key, std::optional<double> fallback = {}) {
    return table.number(key, "m", positive, fallback);
}

void read_plate(TomlTable& table, GeneratedMesh& mesh) {
    mesh.radius = length_of(table, "radius");
    mesh.height = length_of(table, "height", plate_height * mesh.radius);
    const double foot = length_of(table, "foot", plate_foot * mesh.radius);
    if (foot >= mesh.radius)
        table.report("foot", fmt::format("must be less than radius ({} m)", mesh.radius));
    mesh.profile = plate_profile(mesh.radius, mesh.height, foot);
}

void read_bowl(TomlTable& table, GeneratedMesh& mesh) {
    mesh.radius = length_of(table, "radius");
    double cap = table.number("cap_degrees", "degrees", cap_degrees, bowl_cap) * pi / 180;
    if (table.has("height")) {
        if (table.has("cap_degrees")) table.report("height", "conflicts with cap_degrees: give one of them");
        cap = 2 * std::atan(length_of(table, "height") / mesh.radius);
    }
    mesh.height = mesh.radius * std::tan(cap / 2);
    mesh.profile = bowl_profile(mesh.radius, cap);
}

void read_profile(TomlTable& table, GeneratedMesh& mesh) {
    for (const Eigen::VectorXd& point : table.rows("profile", "r, z in m", 2, 2))
        mesh.profile.emplace_back(point[0], point[1]);
    for (std::size_t i = 0; i < mesh.profile.size(); ++i) {
        const bool end = i == 0 || i + 1 == mesh.profile.size();
        if (mesh.profile[i].x() < 0 || (mesh.profile[i].x() == 0 && !end))
            table.report("profile", fmt::format("point {} has r = {}: r must be positive, or 0 at an end",
                                                i + 1, mesh.profile[i].x()));
        if (i > 0 && mesh.profile[i] == mesh.profile[i - 1])
            table.report("profile", fmt::format("points {} and {} are the same: leave one out", i, i + 1));
    }
    if (std::all_of(mesh.profile.begin(), mesh.profile.end(), [](const auto& p) { return p.x() == 0; }) &&
        !mesh.profile.empty())
        table.report("profile", "lies on the axis: give a point with r > 0");
    mesh.angle = table.number("angle", "degrees", sector_degrees, mesh.angle);
    if (mesh.angle < 360 && !mesh.profile.empty() &&
        (mesh.profile.front().x() == 0 || mesh.profile.back().x() == 0))
        table.report("angle", "is for a profile that does not touch the axis (r > 0 everywhere)");
}

Polyline polyline(const std::vector<Eigen::VectorXd>& rows) {
    return {rows.begin(), rows.end()};
}

std::vector<Polyline> polylines(TomlTable& table, std::string_view key, std::size_t least) {
    std::vector<Polyline> lines;
    if (table.has(key))
        for (const auto& rows : table.lists_of_rows(key, "x, y in m", least, 2))
            lines.push_back(polyline(rows));
    return lines;
}

void read_polygon(TomlTable& table, GeneratedMesh& mesh) {
    mesh.polygon.outline = polyline(table.rows("outline", "x, y in m", 3, 2));
    mesh.polygon.holes = polylines(table, "holes", 3);
    mesh.polygon.slits = polylines(table, "slits", 2);
    if (mesh.polygon.outline.empty()) return;
    if (const auto fault = fault_of(mesh.polygon)) table.report(fault->part, fault->what);
}

double smaller_side(const Polyline& line) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : line) box.extend(p);
    return box.sizes().minCoeff();
}

/// Area (m^2) and the smallest size (m) that the edge length must resolve.
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

GeneratedMesh read_shape(TomlTable& table) {
    GeneratedMesh mesh;
    mesh.shape = table.choice("generate", shapes);
    if (mesh.shape.empty()) return mesh;
    if (mesh.shape == "rectangle") mesh.width = length_of(table, "width");
    if (mesh.shape == "disc" || mesh.shape == "cylinder" || mesh.shape == "sphere")
        mesh.radius = length_of(table, "radius");
    if (mesh.shape == "rectangle" || mesh.shape == "cylinder") mesh.height = length_of(table, "height");
    if (mesh.shape == "plate") read_plate(table, mesh);
    if (mesh.shape == "bowl") read_bowl(table, mesh);
    if (mesh.shape == "revolution") read_profile(table, mesh);
    if (mesh.shape == "polygon") read_polygon(table, mesh);
    mesh.edge_length = length_of(table, "edge_length");
    mesh.structured = table.flag("structured", false);
    check_edge_length(table, mesh);
    table.finish();
    return mesh;
}

MeshFile read_mesh_file(TomlTable& table, const std::filesystem::path& directory) {
    MeshFile mesh;
    const std::string name = table.string("file", "the name of a mesh file");
    mesh.path = directory / name;
    mesh.repair = table.flag("repair", true);
    if (table.is_number("join"))
        mesh.join_distance = table.number("join", "m", positive);
    else
        mesh.join = table.flag("join", false);
    mesh.has_size = table.has("scale") || table.has("size");
    mesh.scale = table.number("scale", "m per unit of the file", positive, 1);
    if (table.has("size")) read_size(table, mesh);
    return mesh;
}

}  // namespace sherd
