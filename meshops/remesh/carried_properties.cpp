// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/carried_properties.h"

#include "meshops/face_groups.h"
#include "meshops/file_weights.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_mesh.h"
#include "meshops/surface_colour.h"
#include "meshops/surface_material.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

/// The face of the surface below the middle of a face.
Face face_below(const InputSurface& surface, const std::vector<Face>& below, const Mesh& mesh, Face face) {
    const Vector3d middle = centroid(mesh, face);
    const Vector3d normal = triangle_normal(face_points(mesh, face));
    Face best;
    double least = std::numeric_limits<double>::infinity();
    for (const Vertex corner : face_corners(mesh, face)) {
        const InputSurface::Site found = surface.nearest(below[corner], middle);
        const bool looks_away = triangle_normal(face_points(surface.mesh, found.face)).dot(normal) < 0;
        const double distance = (found.place - middle).norm() * (looks_away ? 10 : 1);
        if (!(distance < least)) continue;
        least = distance;
        best = found.face;
    }
    return best;
}

FaceTexture texture_on(const InputSurface& surface, const Mesh::Property_map<Face, FaceTexture>& texture,
                       Face side, const Mesh& mesh, Face face) {
    FaceTexture result;
    const std::array<Vector3d, 3> corners = face_points(mesh, face);
    for (std::size_t i = 0; i < 3; ++i) {
        const InputSurface::Site at = surface.nearest(side, corners[i], false);
        const FaceTexture& of = texture[at.face];
        result[i] = at.weights[0] * of[0] + at.weights[1] * of[1] + at.weights[2] * of[2];
    }
    return result;
}

void carry_file_vertices(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh) {
    const auto [number, exists] = find_property<Vertex, std::uint32_t>(surface.mesh, property::file_vertex);
    if (!exists) return;
    auto places = mesh.add_property_map<Vertex, FileWeights>(property::file_weights).first;
    for (const Vertex v : mesh.vertices()) {
        const InputSurface::Site at = surface.nearest(below[v], position(mesh, v));
        const std::array<Vertex, 3> corners = face_corners(surface.mesh, at.face);
        places[v] = {{number[corners[0]], number[corners[1]], number[corners[2]]}, at.weights};
    }
}

void carry_vertex_colour(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh) {
    const auto [colour, exists] = find_property<Vertex, Colour>(surface.mesh, property::vertex_colour);
    if (!exists) return;
    auto carried = mesh.add_property_map<Vertex, Colour>(property::vertex_colour).first;
    for (const Vertex v : mesh.vertices()) {
        const InputSurface::Site at = surface.nearest(below[v], position(mesh, v));
        const std::array<Vertex, 3> corners = face_corners(surface.mesh, at.face);
        ColourMean mean;
        for (int k = 0; k < 3; ++k) mean.add(colour[corners[k]], at.weights[k]);
        carried[v] = mean.colour();
    }
}

/// Whether the mesh has properties of faces.
bool has_face_values(const Mesh& mesh) {
    return find_property<Face, FaceTexture>(mesh, property::texture).second ||
           find_property<Face, GroupNames>(mesh, property::groups).second ||
           find_property<Face, Vector3d>(mesh, property::axis).second ||
           find_property<Face, FaceMaterial>(mesh, property::surface_material).second ||
           find_property<Face, Colour>(mesh, property::face_colour).second;
}

/// Copies a property of faces. side: [F] the face of the surface whose value each face gets.
template <class Value>
void carry_values(const InputSurface& surface, const std::vector<Face>& side, const char* name, Mesh& mesh) {
    const auto [values, exists] = find_property<Face, Value>(surface.mesh, name);
    if (!exists) return;
    auto carried = mesh.add_property_map<Face, Value>(name).first;
    for (const Face face : mesh.faces()) carried[face] = values[side[face]];
}

}  // namespace

void carry_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh) {
    carry_file_vertices(surface, below, mesh);
    carry_vertex_colour(surface, below, mesh);
    if (!has_face_values(surface.mesh)) return;
    const auto [texture, has_texture] = find_property<Face, FaceTexture>(surface.mesh, property::texture);
    Mesh::Property_map<Face, FaceTexture> new_texture;
    if (has_texture) new_texture = mesh.add_property_map<Face, FaceTexture>(property::texture).first;
    std::vector<Face> side;
    for (const Face face : mesh.faces()) {
        side.push_back(face_below(surface, below, mesh, face));
        if (has_texture) new_texture[face] = texture_on(surface, texture, side.back(), mesh, face);
    }
    carry_values<GroupNames>(surface, side, property::groups, mesh);
    carry_values<Vector3d>(surface, side, property::axis, mesh);
    carry_values<FaceMaterial>(surface, side, property::surface_material, mesh);
    carry_values<Colour>(surface, side, property::face_colour, mesh);
}

}  // namespace sherd
