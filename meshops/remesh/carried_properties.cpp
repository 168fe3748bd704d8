// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/carried_properties.h"

#include "meshops/face_groups.h"
#include "meshops/file_weights.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_mesh.h"
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
    const auto [number, exists] = surface.mesh.property_map<Vertex, std::uint32_t>(property::file_vertex);
    if (!exists) return;
    auto places = mesh.add_property_map<Vertex, FileWeights>(property::file_weights).first;
    for (const Vertex v : mesh.vertices()) {
        const InputSurface::Site at = surface.nearest(below[v], position(mesh, v));
        const std::array<Vertex, 3> corners = face_corners(surface.mesh, at.face);
        places[v] = {{number[corners[0]], number[corners[1]], number[corners[2]]}, at.weights};
    }
}

}  // namespace

void carry_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh) {
    carry_file_vertices(surface, below, mesh);
    const auto [texture, has_texture] = surface.mesh.property_map<Face, FaceTexture>(property::texture);
    const auto [groups, has_groups] = surface.mesh.property_map<Face, GroupNames>(property::groups);
    const auto [axis, has_axis] = surface.mesh.property_map<Face, Vector3d>(property::axis);
    const auto [material, has_material] =
        surface.mesh.property_map<Face, FaceMaterial>(property::surface_material);
    if (!has_texture && !has_groups && !has_axis && !has_material) return;
    Mesh::Property_map<Face, FaceTexture> new_texture;
    Mesh::Property_map<Face, GroupNames> new_groups;
    Mesh::Property_map<Face, Vector3d> new_axis;
    Mesh::Property_map<Face, FaceMaterial> new_material;
    if (has_texture) new_texture = mesh.add_property_map<Face, FaceTexture>(property::texture).first;
    if (has_groups) new_groups = mesh.add_property_map<Face, GroupNames>(property::groups).first;
    if (has_axis) new_axis = mesh.add_property_map<Face, Vector3d>(property::axis).first;
    if (has_material)
        new_material = mesh.add_property_map<Face, FaceMaterial>(property::surface_material).first;
    for (const Face face : mesh.faces()) {
        const Face side = face_below(surface, below, mesh, face);
        if (has_texture) new_texture[face] = texture_on(surface, texture, side, mesh, face);
        if (has_groups) new_groups[face] = groups[side];
        if (has_axis) new_axis[face] = axis[side];
        if (has_material) new_material[face] = material[side];
    }
}

}  // namespace sherd
