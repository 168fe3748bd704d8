// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/surface_look.h"

#include <map>
#include <utility>

#include "meshops/face_groups.h"

namespace sherd {
namespace {

CornerTexture corner_texture(const Mesh& mesh) {
    CornerTexture corners;
    const auto [texture, exists] = mesh.property_map<Face, FaceTexture>(property::texture);
    if (!exists) return corners;
    corners.resize(6, static_cast<Eigen::Index>(mesh.number_of_faces()));
    for (const Face face : mesh.faces())
        corners.col(face.idx()) << texture[face][0], texture[face][1], texture[face][2];
    return corners;
}

/// Numbers the values that faces share, in the order of the faces. Null is -1.
template <class Value, class Row>
void number_values(const Mesh& mesh, const char* name, const auto& key, std::vector<Index>& numbers,
                   std::vector<Row>& rows) {
    const auto [values, exists] = mesh.property_map<Face, Value>(name);
    if (!exists) return;
    std::map<decltype(key(*values[Face(0)])), Index> known;
    for (const Face face : mesh.faces()) {
        if (!values[face]) {
            numbers.push_back(-1);
            continue;
        }
        const auto [entry, is_new] = known.try_emplace(key(*values[face]), static_cast<Index>(rows.size()));
        if (is_new) rows.push_back(*values[face]);
        numbers.push_back(entry->second);
    }
}

template <class Element, class Value>
void take_property(Mesh& mesh, const Mesh& of, const char* name, const Value& otherwise) {
    if (of.property_map<Element, Value>(name).second) mesh.add_property_map<Element, Value>(name, otherwise);
}

}  // namespace

bool SurfaceLook::operator==(const SurfaceLook& other) const {
    return texture.cols() == other.texture.cols() && texture == other.texture && material == other.material &&
           materials == other.materials && group == other.group && groups == other.groups &&
           face_colour == other.face_colour && vertex_colour == other.vertex_colour;
}

SurfaceLook surface_look(const Mesh& mesh, std::span<const Index> original, std::size_t count) {
    SurfaceLook look;
    look.texture = corner_texture(mesh);
    number_values<FaceMaterial>(
        mesh, property::surface_material,
        [](const SurfaceMaterial& material) { return std::pair(material.name, material.definition); },
        look.material, look.materials);
    number_values<GroupNames>(
        mesh, property::groups, [](const std::vector<std::string>& names) { return names; }, look.group,
        look.groups);
    if (const auto [colour, exists] = mesh.property_map<Face, Colour>(property::face_colour); exists)
        for (const Face face : mesh.faces()) look.face_colour.push_back(colour[face]);
    if (const auto [colour, exists] = mesh.property_map<Vertex, Colour>(property::vertex_colour); exists) {
        look.vertex_colour.assign(count, white);
        for (const Vertex v : mesh.vertices()) look.vertex_colour[original[v]] = colour[v];
    }
    return look;
}

void take_looks(Mesh& mesh, const Mesh& of) {
    const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
    take_property<Face>(mesh, of, property::texture, FaceTexture{zero, zero, zero});
    take_property<Face>(mesh, of, property::surface_material, FaceMaterial());
    take_property<Face>(mesh, of, property::groups, GroupNames());
    take_property<Face>(mesh, of, property::face_colour, white);
    take_property<Vertex>(mesh, of, property::vertex_colour, white);
}

}  // namespace sherd
