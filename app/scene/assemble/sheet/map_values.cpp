// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/map_values.h"

#include <fmt/format.h>

#include "app/files/picture/image.h"
#include "app/messages/place_text.h"
#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/level_set/float_grid.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double grey(const Image& image, const Vector2d& uv) {
    double grey = 0;
    for (const WeightedColour& texel : texels_around(image, uv))
        grey += texel.weight * texel.colour.cast<double>().mean();
    return grey;
}

std::vector<double> at_vertices(const MapTexture& map, const SheetSpec&, const Mesh& mesh,
                                std::vector<std::string>&) {
    const Image image = read_png(map.path);
    const auto texture = texture_coordinates(mesh);
    std::vector<double> values(mesh.number_of_vertices(), 0);
    std::vector<int> faces(mesh.number_of_vertices(), 0);
    for (const Face face : mesh.faces()) {
        auto corner = texture[face].begin();
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) {
            values[v] += grey(image, *corner++);
            ++faces[v];
        }
    }
    for (std::size_t v = 0; v < values.size(); ++v) values[v] /= faces[v];
    return values;
}

std::vector<double> at_edges(const MapTexture& map, const SheetSpec&, const Mesh& mesh,
                             std::vector<std::string>&) {
    const Image image = read_png(map.path);
    const auto texture = texture_coordinates(mesh);
    std::vector<double> values(mesh.number_of_edges(), 0);
    for (const Face face : mesh.faces()) {
        int corner = 0;  // corner at the target of h; its source is at the corner before
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            const Vector2d between = (texture[face][(corner + 2) % 3] + texture[face][corner]) / 2;
            values[mesh.edge(h)] += grey(image, between) / (mesh.is_border(mesh.edge(h)) ? 1 : 2);
            ++corner;
        }
    }
    return values;
}

/// Returns the values of a grid at places of a sheet. what: noun for the places in the warning.
std::vector<double> at_places(const MapGrid& map, const SheetSpec& sheet, std::vector<Vector3d> places,
                              const char* what, std::vector<std::string>& warnings) {
    const Eigen::Affine3d back = to_file(sheet);
    for (Vector3d& place : places) place = back * place;
    const GridSamples samples = sample_float_grid(map.path, map.name, places);
    if (samples.outside > 0)
        warnings.push_back(fmt::format(
            "{} of {} {} lie outside the active region of {} and take its background value, {:.4g}",
            samples.outside, places.size(), what, map.path.string(), samples.background));
    return samples.values;
}

std::vector<double> at_vertices(const MapGrid& map, const SheetSpec& sheet, const Mesh& mesh,
                                std::vector<std::string>& warnings) {
    std::vector<Vector3d> places;
    for (const Vertex v : mesh.vertices()) places.push_back(position(mesh, v));
    return at_places(map, sheet, std::move(places), "vertices", warnings);
}

std::vector<double> at_edges(const MapGrid& map, const SheetSpec& sheet, const Mesh& mesh,
                             std::vector<std::string>& warnings) {
    std::vector<Vector3d> places;
    for (const Edge e : mesh.edges()) places.push_back(edge_middle(mesh, e));
    return at_places(map, sheet, std::move(places), "edges", warnings);
}

double mean_of(const std::vector<double>& of_file, const FileWeights& place) {
    double value = 0;
    for (int i = 0; i < 3; ++i) value += place.weights[i] * of_file[place.vertices[i]];
    return value;
}

std::vector<double> at_vertices(const MapProperty& map, const SheetSpec& sheet, const Mesh& mesh,
                                std::vector<std::string>&) {
    const auto* file = std::get_if<MeshFile>(&sheet.mesh);
    if (file == nullptr) throw Error("the mesh is not from a file, so it has no properties: give a PLY file");
    const std::vector<double> of_file = read_vertex_property(file->path, map.name);
    const auto [number, is_as_read] = find_property(mesh, attribute::file_vertex);
    const auto place = find_property(mesh, attribute::file_weights).first;
    std::vector<double> values;
    for (const Vertex v : mesh.vertices()) {
        if (is_as_read) values.push_back(of_file[number[v]]);
        if (!is_as_read) values.push_back(mean_of(of_file, place[v]));
    }
    return values;
}

std::vector<double> at_edges(const MapProperty& map, const SheetSpec& sheet, const Mesh& mesh,
                             std::vector<std::string>& warnings) {
    const std::vector<double> ends = at_vertices(map, sheet, mesh, warnings);
    std::vector<double> values;
    for (const Edge e : mesh.edges())
        values.push_back(0.5 * (ends[mesh.vertex(e, 0)] + ends[mesh.vertex(e, 1)]));
    return values;
}

}  // namespace

Mesh::Property_map<Face, FaceTexture> texture_coordinates(const Mesh& mesh) {
    const auto [texture, exists] = find_property(mesh, attribute::texture);
    if (!exists) throw Error("the mesh has no texture coordinates: give an OBJ file with vt lines");
    for (const Face face : mesh.faces())
        for (const Eigen::Vector2d& corner : texture[face])
            if (!corner.allFinite())
                throw Error(
                    fmt::format("the texture coordinates of {} are NaN or infinite: unwrap the mesh again",
                                face_text(mesh, face)));
    return texture;
}

std::vector<double> vertex_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                  std::vector<std::string>& warnings) {
    return std::visit([&](const auto& map) { return at_vertices(map, sheet, placed, warnings); }, source);
}

std::vector<double> edge_values(const MapSource& source, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings) {
    return std::visit([&](const auto& map) { return at_edges(map, sheet, placed, warnings); }, source);
}

std::string source_text(const MapSource& source) {
    if (const auto* property = std::get_if<MapProperty>(&source)) return "the property " + property->name;
    if (const auto* texture = std::get_if<MapTexture>(&source)) return texture->path.string();
    return std::get<MapGrid>(source).path.string();
}

Eigen::Affine3d to_file(const SheetSpec& sheet) {
    const auto* file = std::get_if<MeshFile>(&sheet.mesh);
    return Eigen::Scaling(1 / (file ? file->scale : 1)) * Eigen::Affine3d(sheet.place.inverse());
}

Eigen::Vector3d edge_middle(const Mesh& mesh, Edge edge) {
    return (position(mesh, mesh.vertex(edge, 0)) + position(mesh, mesh.vertex(edge, 1))) / 2;
}

}  // namespace sherd
