// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/face_properties.h"

#include <algorithm>
#include <limits>

#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_mesh.h"
#include "meshops/surface_colour.h"
#include "meshops/surface_material.h"

namespace sherd {
namespace {

using Parents = std::vector<Born<Vertex>::Parent>;
using Shares = std::vector<Born<Face>::Parent>;

/// Weights of a face's corners among the parents of a vertex; nullopt if the vertex has other parents, too.
std::optional<Eigen::Vector3d> corner_weights(const ReplacedFace& face, const Parents& parents) {
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    for (const auto& [vertex, weight] : parents) {
        const std::size_t corner = corner_number(face.corners, vertex);
        if (corner == 3) return std::nullopt;
        weights[static_cast<Eigen::Index>(corner)] += weight;
    }
    return weights;
}

/// Texture coordinates of a vertex in a face with these shares: those in the largest share in which the
/// vertex lies.
Eigen::Vector2d texture_at(const std::map<Face, ReplacedFace>& old, const Shares& shares,
                           const Parents& parents, const Eigen::Vector2d& otherwise) {
    for (const auto& [face, share] : shares) {
        const ReplacedFace& was = old.at(face);
        if (const auto weights = corner_weights(was, parents))
            return (*weights)[0] * was.texture[0] + (*weights)[1] * was.texture[1] +
                   (*weights)[2] * was.texture[2];
    }
    return otherwise;
}

void inherit_texture(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change) {
    auto [texture, exists] = find_property<Face, FaceTexture>(mesh, property::texture);
    if (!exists) return;
    std::map<Vertex, Parents> parents;
    for (const auto* vertices : {&change.vertices, &change.moved})
        for (const Born<Vertex>& vertex : *vertices) parents[vertex.element] = vertex.parents;
    for (const auto& [face, shares] : change.reshaped) {
        const std::array<Vertex, 3> corners = face_corners(mesh, face);
        for (int i = 0; i < 3; ++i) {
            const auto known = parents.find(corners[i]);
            const Parents own{{corners[i], 1}};
            texture[face][i] = texture_at(old, shares, known == parents.end() ? own : known->second,
                                          old.at(shares.front().element).texture[i]);
        }
    }
}

void inherit_axis(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change) {
    auto [axis, exists] = find_property<Face, Eigen::Vector3d>(mesh, property::axis);
    if (!exists) return;
    std::map<Face, Eigen::Vector3d> before;
    for (const auto& [face, was] : old) before[face] = axis[face];
    for (const auto& [face, shares] : change.reshaped) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [parent, share] : shares) sum += share * old.at(parent).area * before[parent];
        const double length = before[shares.front().element].norm();
        axis[face] =
            sum.norm() > 0 ? Eigen::Vector3d(sum * (length / sum.norm())) : before[shares.front().element];
    }
}

/// Gives each reshaped face the value of the old face with the largest share.
template <class Value>
void inherit_largest(Mesh& mesh, const TopologyChange& change, const char* name) {
    auto [values, exists] = find_property<Face, Value>(mesh, name);
    if (!exists) return;
    std::map<Face, Value> now;
    for (const auto& [face, shares] : change.reshaped) now[face] = values[shares.front().element];
    for (const auto& [face, value] : now) values[face] = value;
}

void inherit_vertex_colour(Mesh& mesh, const TopologyChange& change) {
    auto [colour, exists] = find_property<Vertex, Colour>(mesh, property::vertex_colour);
    if (!exists) return;
    std::map<Vertex, Colour> now;
    for (const auto* vertices : {&change.vertices, &change.moved})
        for (const Born<Vertex>& vertex : *vertices) {
            ColourMean mean;
            for (const auto& [parent, weight] : vertex.parents) mean.add(colour[parent], weight);
            now[vertex.element] = mean.colour();
        }
    for (const auto& [vertex, mean] : now) colour[vertex] = mean;
}

}  // namespace

void inherit_properties(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change) {
    inherit_texture(mesh, old, change);
    inherit_axis(mesh, old, change);
    inherit_largest<GroupNames>(mesh, change, property::groups);
    inherit_largest<FaceMaterial>(mesh, change, property::surface_material);
    inherit_largest<Colour>(mesh, change, property::face_colour);
    inherit_vertex_colour(mesh, change);
    auto [number, exists] = find_property<Vertex, std::uint32_t>(mesh, property::file_vertex);
    if (!exists) return;
    for (const Born<Vertex>& vertex : change.vertices)
        number[vertex.element] = std::numeric_limits<std::uint32_t>::max();
}

}  // namespace sherd
