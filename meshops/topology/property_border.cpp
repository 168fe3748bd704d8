// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/property_border.h"

#include "meshops/attributes.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

/// Returns the texture coordinates that the face of h has at the source and at the target of h.
std::array<Eigen::Vector2d, 2> texture_along(const Mesh& mesh, Halfedge h, const FaceTexture& texture) {
    const std::array<Vertex, 3> corners = face_corners(mesh, mesh.face(h));
    const auto at = [&](Vertex v) { return texture[corner_number(corners, v)]; };
    return {at(mesh.source(h)), at(mesh.target(h))};
}

bool is_seam(const Mesh& mesh, Halfedge h, Halfedge other) {
    const auto [texture, exists] = find_property(mesh, attribute::texture);
    if (!exists) return false;
    const auto here = texture_along(mesh, h, texture[mesh.face(h)]);
    const auto there = texture_along(mesh, other, texture[mesh.face(other)]);
    return here[0] != there[1] || here[1] != there[0];
}

bool separates_groups(const Mesh& mesh, Halfedge h, Halfedge other) {
    const auto [groups, exists] = find_property(mesh, attribute::groups);
    return exists && !is_same(groups[mesh.face(h)], groups[mesh.face(other)]);
}

bool separates_materials(const Mesh& mesh, Halfedge h, Halfedge other) {
    const auto [material, exists] = find_property(mesh, attribute::surface_material);
    return exists && !is_same(material[mesh.face(h)], material[mesh.face(other)]);
}

}  // namespace

bool is_property_border(const Mesh& mesh, Halfedge h) {
    const Halfedge other = mesh.opposite(h);
    if (mesh.is_border(h) || mesh.is_border(other)) return false;
    return is_seam(mesh, h, other) || separates_groups(mesh, h, other) || separates_materials(mesh, h, other);
}

}  // namespace sherd
