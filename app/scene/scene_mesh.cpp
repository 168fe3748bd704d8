// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/nearest_name.h"
#include "app/scene/scene_shape.h"
#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_mesh.h"
#include "meshops/remesh.h"

namespace sherd {
namespace {

void transform(Mesh& mesh, const Eigen::Affine3d& map) {
    for (const Vertex v : mesh.vertices()) {
        const Vector3d p = map * position(mesh, v);
        mesh.point(v) = Point(p.x(), p.y(), p.z());
    }
}

Mesh make(const GeneratedMesh& spec, const Scene& scene, std::vector<std::string>&) {
    GenerateOptions options;
    options.edge_length = spec.edge_length;
    options.layout = spec.structured ? Layout::structured : Layout::delaunay;
    options.seed = static_cast<unsigned>(scene.seed);
    if (spec.shape == "rectangle") return generate_rectangle(spec.width, spec.height, options);
    if (spec.shape == "disc") return generate_disc(spec.radius, options);
    if (spec.shape == "cylinder") return generate_cylinder(spec.radius, spec.height, options);
    if (spec.shape == "sphere") return generate_sphere(spec.radius, options);
    return generate_revolution(spec.profile, options);
}

Mesh make(const MeshFile& spec, const Scene&, std::vector<std::string>& warnings) {
    Mesh mesh = read_mesh(spec, warnings);
    if (spec.remesh == 0) return mesh;
    const double faces = expected_faces(measure(mesh).area, spec.remesh);
    if (faces > most_faces)
        throw Error(
            fmt::format("remesh = {} would make about {:.2g} faces, more than {:.0g}: give a larger one",
                        spec.remesh, faces, most_faces));
    return remesh(mesh, spec.remesh);
}

}  // namespace

MeshFile read_mesh_file(TomlTable& table, const std::filesystem::path& directory) {
    MeshFile mesh;
    const std::string name = table.string("file", "the name of a mesh file");
    mesh.path = directory / name;
    mesh.repair = table.flag("repair", false);
    mesh.join = table.flag("join", false);
    mesh.scale = table.number("scale", "m per unit of the file", positive, 1);
    return mesh;
}

Mesh read_mesh(const MeshFile& spec, std::vector<std::string>& warnings) {
    Mesh mesh = read_mesh(spec.path, {.join_duplicate_points = spec.join, .repair = spec.repair}, warnings);
    if (spec.scale != 1) transform(mesh, Eigen::Affine3d(Eigen::Scaling(spec.scale)));
    return mesh;
}

Mesh make_unplaced_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings) {
    std::vector<std::string> found;
    Mesh mesh = with_context(sheet.where, [&] {
        return std::visit([&](const auto& spec) { return make(spec, scene, found); }, sheet.mesh);
    });
    for (const std::string& warning : found) warnings.push_back(fmt::format("{}: {}", sheet.where, warning));
    return mesh;
}

Mesh make_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings) {
    Mesh mesh = make_unplaced_mesh(sheet, scene, warnings);
    transform(mesh, Eigen::Affine3d(sheet.place));
    return mesh;
}

bool selects(const Selection& selection, const Mesh& mesh, Vertex v) {
    if (selection.boundary) return mesh.is_border(v);
    if (!selection.group.empty()) return is_in_group(mesh, v, selection.group);
    if (!selection.box) return true;
    const Vector3d p = position(mesh, v);
    return (p.array() >= selection.box->first.array()).all() &&
           (p.array() <= selection.box->second.array()).all();
}

void check_group(const Selection& selection, const std::vector<std::string>& known) {
    if (selection.group.empty() || std::find(known.begin(), known.end(), selection.group) != known.end())
        return;
    if (known.empty())
        throw Error(
            fmt::format("{}: the mesh has no groups; they are `g` or `o` lines of an OBJ file, and remeshing "
                        "loses them",
                        selection.where));
    const std::string nearest = nearest_name(selection.group, known);
    const std::string hint = nearest.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                             : fmt::format("did you mean '{}'?", nearest);
    throw Error(fmt::format("{}: the mesh has no group '{}'; {}", selection.where, selection.group, hint));
}

std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed) {
    std::vector<bool> held(placed.number_of_vertices(), false);
    std::vector<PinSpec> holds = sheet.pins;
    holds.insert(holds.end(), sheet.clamps.begin(), sheet.clamps.end());
    for (const PinSpec& hold : holds) {
        const Selection& pin = hold.on;
        check_group(pin, group_names(placed));
        bool any = false;
        for (const Vertex v : placed.vertices())
            if (selects(pin, placed, v)) any = held[v] = true;
        if (!any)
            throw Error(fmt::format(
                "{}: holds no vertex: its box, boundary or group must reach the placed sheet", pin.where));
    }
    std::vector<std::int32_t> numbers;
    for (std::size_t v = 0; v < held.size(); ++v)
        if (held[v]) numbers.push_back(static_cast<std::int32_t>(v));
    return numbers;
}

}  // namespace sherd
