// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/mesh/mesh_state.h"

#include <stdexcept>

#include "meshops/shared_values.h"

namespace sherd {
namespace {

struct HalfedgeLinks {
    Vertex target;
    Halfedge next;
    Face face;  ///< invalid: the halfedge is on a border
};

void visit_size(StateVisitor& visit, Mesh& mesh) {
    std::array<std::size_t, 3> size{mesh.number_of_vertices(), mesh.number_of_edges(),
                                    mesh.number_of_faces()};
    visit(size);
    if (visit.reads()) mesh.resize(size[0], size[1], size[2]);
}

void visit_links(StateVisitor& visit, Mesh& mesh) {
    for (const Vertex vertex : mesh.vertices()) {
        Halfedge halfedge = mesh.halfedge(vertex);
        visit(halfedge);
        mesh.set_halfedge(vertex, halfedge);
    }
    for (const Face face : mesh.faces()) {
        Halfedge halfedge = mesh.halfedge(face);
        visit(halfedge);
        mesh.set_halfedge(face, halfedge);
    }
    for (const Halfedge halfedge : mesh.halfedges()) {
        HalfedgeLinks links{mesh.target(halfedge), mesh.next(halfedge), mesh.face(halfedge)};
        visit(links);
        mesh.set_target(halfedge, links.target);
        mesh.set_next(halfedge, links.next);
        mesh.set_face(halfedge, links.face);
    }
}

void visit_points(StateVisitor& visit, Mesh& mesh) {
    for (const Vertex vertex : mesh.vertices()) {
        const Point& point = mesh.point(vertex);
        std::array<double, 3> at{point.x(), point.y(), point.z()};
        visit(at);
        if (visit.reads()) mesh.point(vertex) = Point(at[0], at[1], at[2]);
    }
}

/// Visits materials, which have no visit_state().
void visit_rows(StateVisitor& visit, std::vector<SurfaceMaterial>& materials) {
    std::vector<std::array<std::string, 2>> texts;
    for (const auto& [name, definition] : materials) texts.push_back({name, definition});
    visit(texts);
    if (!visit.reads()) return;
    materials.clear();
    for (const auto& [name, definition] : texts) materials.push_back({name, definition});
}

void visit_rows(StateVisitor& visit, std::vector<std::vector<std::string>>& groups) {
    visit(groups);
}

template <class Value>
void visit_list(StateVisitor& visit, std::vector<Value>& values) {
    visit(values);
}

template <class T>
void visit_list(StateVisitor& visit, std::vector<std::shared_ptr<const T>>& values) {
    SharedValues<T> shared = shared_values(values);
    visit_rows(visit, shared.rows);
    visit(shared.number);
    if (visit.reads()) values = listed(shared);
}

template <class Element, class Value, Inherits rule>
void visit_property(StateVisitor& visit, Mesh& mesh, const Attribute<Element, Value, rule>& attribute) {
    auto [values, exists] = find_property(mesh, attribute);
    if (!exists) return;
    std::vector<Value> list;
    for (const Element element : elements<Element>(mesh)) list.push_back(values[element]);
    visit_list(visit, list);
    if (!visit.reads()) return;
    for (const Element element : elements<Element>(mesh)) values[element] = list[element.idx()];
}

}  // namespace

void visit_mesh(StateVisitor& visit, Mesh& mesh) {
    if (mesh.has_garbage()) throw std::logic_error("visit_mesh: the mesh has removed elements");
    visit_size(visit, mesh);
    visit_links(visit, mesh);
    visit_points(visit, mesh);
    visit_mesh_attributes([&](const auto& attribute) { visit_property(visit, mesh, attribute); });
}

void visit_look(StateVisitor& visit, SurfaceLook& look) {
    visit_surface_attributes([&](const auto& attribute) { visit_list(visit, look.*attribute.list); });
}

}  // namespace sherd
