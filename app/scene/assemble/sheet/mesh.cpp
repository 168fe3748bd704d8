// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/remesh/remesh.h"
#include "meshops/repair/triangle_mesh.h"
#include "meshops/topology/advance/line_cut.h"

namespace sherd {
namespace {

void transform(Mesh& mesh, const Eigen::Affine3d& map) {
    for (const Vertex v : mesh.vertices()) {
        const Vector3d p = map * position(mesh, v);
        mesh.point(v) = point_at(p);
    }
}

/// Inserts edges along the lines of the sheet's initial cracks into a generated mesh; other meshes are kept
/// as they are.
void cut_cracks(Mesh& mesh, const SheetSpec& sheet) {
    if (!sheet.fracture || !std::holds_alternative<GeneratedMesh>(sheet.mesh)) return;
    LineCut cut(mesh, false);
    for (const Score& crack : sheet.fracture->cracks) {
        const auto* line = std::get_if<ScoreLine>(&crack.kind);
        if (line == nullptr) continue;
        std::vector<LinePoint> points;
        for (const Vector3d& point : line->points)
            points.push_back({point, fmt::format("point {}", points.size())});
        with_context(crack.where, [&] { cut.cut(points); });
    }
}

Mesh make(const GeneratedMesh& spec, const Scene& scene, std::vector<std::string>&, std::string*) {
    GenerateOptions options;
    options.edge_length = spec.edge_length;
    options.layout = spec.structured ? Layout::structured : Layout::delaunay;
    options.seed = static_cast<unsigned>(scene.seed);
    if (spec.shape == "rectangle") return generate_rectangle(spec.width, spec.height, options);
    if (spec.shape == "disc") return generate_disc(spec.radius, options);
    if (spec.shape == "cylinder") return generate_cylinder(spec.radius, spec.height, options);
    if (spec.shape == "sphere") return generate_sphere(spec.radius, options);
    if (spec.shape == "polygon") return generate_polygon(spec.polygon, options);
    return generate_revolution(spec.profile, options, spec.angle);
}

void warn_of_remesh(double edge_length, const Mesh& mesh, const Remeshed& result,
                    std::vector<std::string>& warnings) {
    constexpr double far = 0.25;  // share of the edge length: larger distances from the surface are reported
    if (result.texture_lost)
        warnings.push_back(fmt::format(
            "remesh = {}: the texture coordinates are lost, since most edges of the file are texture seams",
            edge_length));
    if (result.kept > 0)
        warnings.push_back(
            fmt::format("remesh = {}: {} of {} faces stay as they are in the file, where the mesh is so thin "
                        "or sharp that new faces would cross or be tiny; smaller edges may avoid this",
                        edge_length, result.kept, mesh.number_of_faces()));
    if (result.crossings > 0)
        warnings.push_back(fmt::format(
            "remesh = {}: {} more pairs of faces cross than in the file; smaller edges may avoid this",
            edge_length, result.crossings));
    if (result.distance > far * edge_length)
        warnings.push_back(
            fmt::format("remesh = {}: the remeshed surface is up to {:.2g} m from the file's; smaller edges "
                        "keep more of its shape",
                        edge_length, result.distance));
}

Mesh with_edges(Mesh mesh, const std::optional<RemeshOptions>& options, std::vector<std::string>& warnings,
                std::string* remeshed) {
    if (!options) return mesh;
    const double edge_length = options->edge_length;
    const double faces = expected_faces(measure(mesh).area, edge_length);
    if (faces > most_faces)
        throw Error(
            fmt::format("remesh = {} would make about {:.2g} faces, more than {:.0g}: give a larger one",
                        edge_length, faces, most_faces));
    Remeshed result = remesh(mesh, *options);
    warn_of_remesh(edge_length, mesh, result, warnings);
    if (remeshed != nullptr)
        *remeshed = fmt::format("remeshed from {} faces, at most {:.2g} m from the file's surface",
                                mesh.number_of_faces(), result.distance);
    return std::move(result.mesh);
}

Mesh make(const MeshFile& spec, const Scene&, std::vector<std::string>& warnings, std::string* remeshed) {
    return with_edges(read_mesh(spec, warnings), spec.remesh, warnings, remeshed);
}

Mesh make(const GivenMeshName& spec, const Scene& scene, std::vector<std::string>& warnings,
          std::string* remeshed) {
    const auto given = scene.given_meshes.find(spec.name);
    if (given == scene.given_meshes.end())
        throw Error(
            fmt::format("no program has passed a mesh of the name '{}': give a file instead, or pass the "
                        "arrays with the scene",
                        spec.name));
    return with_edges(triangle_mesh(given->second.positions, given->second.faces), spec.remesh, warnings,
                      remeshed);
}

/// Returns the largest side of the bounding box, m.
double size_of(const Mesh& mesh) {
    const MeshMeasures measures = measure(mesh);
    return (measures.upper - measures.lower).maxCoeff();
}

/// Throws Error if a mesh is larger or smaller than any shell. Between these limits doubles have enough
/// digits.
void require_size(const Mesh& mesh) {
    constexpr double smallest = 1e-9, largest = 1e9;  // m
    const double size = size_of(mesh);
    if (size >= smallest && size <= largest) return;
    throw Error(
        fmt::format("the mesh is {:.4g} m large, outside of the range from {:g} to {:g} m: lengths are in m; "
                    "give the mesh of a file a size, or a scale (m per unit of the file)",
                    size, smallest, largest));
}

/// Throws Error if the sheet is so far from the origin that the digits of doubles do not resolve its edges.
void require_near(const Mesh& mesh, const SheetSpec& sheet) {
    constexpr double most_round_off = 1e-4;  // largest round-off of positions, as a share of the mean edge
                                             // length
    const MeshMeasures measures = measure(mesh);
    const double farthest =
        std::max(measures.upper.cwiseAbs().maxCoeff(), measures.lower.cwiseAbs().maxCoeff());
    if (farthest * std::numeric_limits<double>::epsilon() <= most_round_off * measures.mean_edge) return;
    throw Error(
        fmt::format("{}: place: the sheet is {:.3g} m from the origin, where the digits of numbers do not "
                    "resolve its edges of {:.3g} m; place it nearer",
                    sheet.where, farthest, measures.mean_edge));
}

}  // namespace

void warn_of_size(double size, std::vector<std::string>& warnings) {
    constexpr double smallest = 1e-3, largest = 20;  // m
    if (size >= smallest && size <= largest) return;
    warnings.push_back(fmt::format(
        "the mesh is {:.4g} m large, as its numbers are taken for metres: say how large it is with size = "
        "0.2 "
        "(m, the largest extent), or scale = 0.001 (m per unit of the file) where it is in millimetres",
        size));
}

Mesh read_mesh(const MeshFile& spec, std::vector<std::string>& warnings) {
    const ReadMeshOptions options{.join_duplicate_points = spec.join,
                                  .repair = spec.repair ? Repair::all : Repair::none,
                                  .join_distance = spec.join_distance / spec.scale,
                                  .unit = spec.scale};
    Mesh mesh = read_mesh(spec.path, options, warnings);
    if (!spec.has_size) warn_of_size(size_of(mesh), warnings);
    if (spec.scale != 1) transform(mesh, Eigen::Affine3d(Eigen::Scaling(spec.scale)));
    return mesh;
}

Mesh make_unplaced_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                        std::string* remeshed) {
    std::vector<std::string> found;
    Mesh mesh = with_context(sheet.where, [&] {
        Mesh made =
            std::visit([&](const auto& spec) { return make(spec, scene, found, remeshed); }, sheet.mesh);
        require_size(made);
        return made;
    });
    for (const std::string& warning : found) warnings.push_back(fmt::format("{}: {}", sheet.where, warning));
    cut_cracks(mesh, sheet);
    return mesh;
}

Mesh make_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
               std::string* remeshed) {
    Mesh mesh = make_unplaced_mesh(sheet, scene, warnings, remeshed);
    transform(mesh, Eigen::Affine3d(sheet.place));
    require_near(mesh, sheet);
    return mesh;
}

}  // namespace sherd
