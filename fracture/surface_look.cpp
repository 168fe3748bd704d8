// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/surface_look.h"

#include <utility>

#include "fracture/shared_values.h"
#include "meshops/face_groups.h"

namespace sherd {
namespace {

CornerTexture corner_texture(const Mesh& mesh) {
    CornerTexture corners;
    const auto [texture, exists] = find_property<Face, FaceTexture>(mesh, property::texture);
    if (!exists) return corners;
    corners.resize(6, static_cast<Eigen::Index>(mesh.number_of_faces()));
    for (const Face face : mesh.faces())
        corners.col(face.idx()) << texture[face][0], texture[face][1], texture[face][2];
    return corners;
}

template <class Element, class Value>
void take_property(Mesh& mesh, const Mesh& of, const char* name, const Value& otherwise) {
    if (find_property<Element, Value>(of, name).second)
        mesh.add_property_map<Element, Value>(name, otherwise);
}

}  // namespace

bool SurfaceLook::operator==(const SurfaceLook& other) const {
    return texture.cols() == other.texture.cols() && texture == other.texture && material == other.material &&
           materials == other.materials && group == other.group && groups == other.groups &&
           face_colour == other.face_colour && vertex_colour == other.vertex_colour;
}

void visit_materials(StateVisitor& visit, std::vector<SurfaceMaterial>& materials) {
    std::vector<std::array<std::string, 2>> texts;
    for (const auto& [name, definition] : materials) texts.push_back({name, definition});
    visit(texts);
    if (!visit.reads()) return;
    materials.clear();
    for (const auto& [name, definition] : texts) materials.push_back({name, definition});
}

void SurfaceLook::visit_state(StateVisitor& visit) {
    auto& [texture, material, materials, group, groups, face_colour, vertex_colour] = *this;
    visit(texture, material, group, groups, face_colour, vertex_colour);
    visit_materials(visit, materials);
}

Colour SurfaceLook::colour(std::size_t face, Index vertex) const {
    if (!vertex_colour.empty()) return vertex_colour[vertex];
    return face_colour.empty() ? white : face_colour[face];
}

SurfaceLook surface_look(const Mesh& mesh, std::span<const Index> original, std::size_t count) {
    SurfaceLook look;
    look.texture = corner_texture(mesh);
    auto materials = shared_values<SurfaceMaterial>(mesh, property::surface_material);
    look.material = std::move(materials.number);
    look.materials = std::move(materials.rows);
    auto groups = shared_values<std::vector<std::string>>(mesh, property::groups);
    look.group = std::move(groups.number);
    look.groups = std::move(groups.rows);
    if (const auto [colour, exists] = find_property<Face, Colour>(mesh, property::face_colour); exists)
        for (const Face face : mesh.faces()) look.face_colour.push_back(colour[face]);
    if (const auto [colour, exists] = find_property<Vertex, Colour>(mesh, property::vertex_colour); exists) {
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
