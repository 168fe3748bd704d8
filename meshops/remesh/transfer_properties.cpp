// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/transfer_properties.h"

#include "meshops/attributes.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

/// Returns the face of the surface below the middle of `face`, a face of `mesh`.
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
    const auto [number, exists] = find_property(surface.mesh, attribute::file_vertex);
    if (!exists) return;
    auto places = add_property(mesh, attribute::file_weights);
    for (const Vertex v : mesh.vertices()) {
        const InputSurface::Site at = surface.nearest(below[v], position(mesh, v));
        const std::array<Vertex, 3> corners = face_corners(surface.mesh, at.face);
        places[v] = {{number[corners[0]], number[corners[1]], number[corners[2]]}, at.weights};
    }
}

/// Gives each vertex of `mesh` the mean of the values at the corners of the face of the surface below it, by
/// the weights of its place there.
template <class Value, Inherits rule>
void carry(const InputSurface& surface, const std::vector<Face>& below, const std::vector<Face>&, Mesh& mesh,
           const Attribute<Vertex, Value, rule>& attribute) {
    const auto [values, exists] = find_property(surface.mesh, attribute);
    if (!exists) return;
    auto carried = add_property(mesh, attribute);
    for (const Vertex v : mesh.vertices()) {
        const InputSurface::Site at = surface.nearest(below[v], position(mesh, v));
        const std::array<Vertex, 3> corners = face_corners(surface.mesh, at.face);
        Mean<Value> mean;
        for (int k = 0; k < 3; ++k) mean.add(values[corners[k]], at.weights[k]);
        carried[v] = mean.value();
    }
}

/// Gives each face of `mesh` the value of the face of the surface below its middle; texture coordinates are
/// interpolated at each corner. side: [F] the face of the surface below the middle of each face.
template <class Value, Inherits rule>
void carry(const InputSurface& surface, const std::vector<Face>&, const std::vector<Face>& side, Mesh& mesh,
           const Attribute<Face, Value, rule>& attribute) {
    const auto [values, exists] = find_property(surface.mesh, attribute);
    if (!exists) return;
    auto carried = add_property(mesh, attribute);
    for (const Face face : mesh.faces())
        if constexpr (std::same_as<Value, FaceTexture>)
            carried[face] = texture_on(surface, values, side[face], mesh, face);
        else
            carried[face] = values[side[face]];
}

bool has_face_values(const Mesh& mesh) {
    bool any = false;
    visit_attributes_of<Face>(
        [&](const auto& attribute) { any = any || find_property(mesh, attribute).second; });
    return any;
}

}  // namespace

void transfer_properties(const InputSurface& surface, const std::vector<Face>& below, Mesh& mesh) {
    carry_file_vertices(surface, below, mesh);
    std::vector<Face> side;
    if (has_face_values(surface.mesh))
        for (const Face face : mesh.faces()) side.push_back(face_below(surface, below, mesh, face));
    visit_surface_attributes([&](const auto& attribute) { carry(surface, below, side, mesh, attribute); });
}

}  // namespace sherd
