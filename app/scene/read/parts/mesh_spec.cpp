// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/mesh_spec.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/read/parts/profile.h"
#include "app/scene/read/parts/shapes.h"
#include "meshops/error.h"
#include "meshops/soup/polygon_soup.h"

namespace sherd {
namespace {

/// Returns the largest side of the bounding box of a mesh file's polygons, in units of the file; 0 if the
/// file cannot be read, which is reported later, when the mesh is made.
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

constexpr Range feature_degrees{.least = 0, .most = 180, .with_most = true};

constexpr std::array remesh_keys{
    key<&RemeshOptions::edge_length>("edge_length", "target length of the edges",
                                     {.unit = "m", .range = positive, .required = true}),
    key<&RemeshOptions::features>("features",
                                  "angle above which an edge is a feature line, whose shape is kept",
                                  {.unit = "degrees", .range = feature_degrees}),
    key<&RemeshOptions::adaptive>(
        "adaptive", "shorter edges where the surface is curved or feature lines are close together")};
constexpr Section<RemeshOptions> remesh_section{"Remeshing", remesh_keys};

template <class Mesh>
void read_remesh(TomlTable& table, const KeyInfo& key, Mesh& mesh) {
    if (!table.has(key.name)) return;
    if (table.is_table(key.name)) return keys::read_table(table, key, remesh_section, mesh.remesh);
    mesh.remesh.emplace().edge_length = table.number(key.name, key.rules.unit, key.rules.range);
}

std::vector<SectionText> inside_remesh() {
    return {text_of(remesh_section)};
}

template <class Mesh>
constexpr std::array remesh_key{
    special_key("remesh", Form::number | Form::table, "remeshing: the target edge length, or a table",
                {.unit = "m, target edge length", .range = positive, .otherwise = "no remeshing"},
                read_remesh<Mesh>, inside_remesh)};

void complete_mesh_file(TomlTable& table, MeshFile& mesh) {
    mesh.has_size = table.has("scale") || table.has("size");
}

constexpr auto sheet_file_keys = joined(mesh_file_keys, remesh_key<MeshFile>);
constexpr Section<MeshFile> file_section{"A mesh from a file", sheet_file_keys, complete_mesh_file};

constexpr std::array given_name_key{key<&GivenMeshName::name>(
    "given", "name of a mesh that a program passes with the scene",
    {.what = "the name of a mesh that a program passes with the scene", .required = true})};
constexpr auto given_keys = joined(given_name_key, remesh_key<GivenMeshName>);
constexpr Section<GivenMeshName> given_section{"A mesh that a program passes with the scene", given_keys};

}  // namespace

void read_join(TomlTable& table, const KeyInfo& key, MeshFile& mesh) {
    if (table.is_number(key.name))
        mesh.join_distance = table.number(key.name, key.rules.unit, key.rules.range);
    else
        mesh.join = table.flag(key.name, mesh.join);
}

void read_size(TomlTable& table, const KeyInfo& key, MeshFile& mesh) {
    if (!table.has(key.name)) return;
    const double size = table.number(key.name, key.rules.unit, key.rules.range);
    if (const double extent = extent_of(mesh.path); extent > 0) mesh.scale = size / extent;
}

void read_mesh(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    sheet.where = table.where(key.name);
    if (table.is_string(key.name)) {
        sheet.mesh.emplace<MeshFile>().path = table.file(key.name, key.rules.what);
        return;
    }
    std::optional<TomlTable> inner = table.table(key.name);
    if (!inner) {
        if (!table.has(key.name))
            table.report(key.name, "is missing: give a file name, or { generate = \"disc\", ... }");
        return;
    }
    if (inner->has("given")) return read_section(*inner, given_section, sheet.mesh.emplace<GivenMeshName>());
    const bool generated = inner->has("generate"), from_file = inner->has("file");
    if (generated && from_file) return inner->report("file", "conflicts with generate: give one of them");
    if (!generated && !from_file) return inner->report("", "needs one of generate and file");
    if (generated) return read_shape(*inner, sheet.mesh.emplace<GeneratedMesh>());
    read_section(*inner, file_section, sheet.mesh.emplace<MeshFile>());
}

std::vector<SectionText> inside_mesh() {
    std::vector<SectionText> kinds = inside_shapes();
    kinds.insert(kinds.begin(), {text_of(file_section), text_of(given_section)});
    return kinds;
}

}  // namespace sherd
