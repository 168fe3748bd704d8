// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/mesh_state.h"

#include <stdexcept>

#include "fracture/shared_values.h"
#include "fracture/surface_look.h"
#include "meshops/face_groups.h"
#include "meshops/file_weights.h"
#include "meshops/read_mesh.h"

namespace sherd {
namespace {

struct HalfedgeLinks {
    Vertex target;
    Halfedge next;
    Face face;  ///< invalid: a border
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

template <class Element, class T, class Elements>
void visit_property(StateVisitor& visit, Mesh& mesh, const char* name, const Elements& elements) {
    auto [values, exists] = find_property<Element, T>(mesh, name);
    if (!exists) return;
    for (const Element element : elements) visit(values[element]);
}

void visit_groups(StateVisitor& visit, Mesh& mesh) {
    auto groups = shared_values<std::vector<std::string>>(mesh, property::groups);
    if (groups.number.empty()) return;
    visit(groups.rows, groups.number);
    if (visit.reads()) give_values(groups, property::groups, mesh);
}

void visit_surface_materials(StateVisitor& visit, Mesh& mesh) {
    auto materials = shared_values<SurfaceMaterial>(mesh, property::surface_material);
    if (materials.number.empty()) return;
    visit_materials(visit, materials.rows);
    visit(materials.number);
    if (visit.reads()) give_values(materials, property::surface_material, mesh);
}

}  // namespace

void visit_mesh(StateVisitor& visit, Mesh& mesh) {
    if (mesh.has_garbage()) throw std::logic_error("visit_mesh: the mesh has removed elements");
    visit_size(visit, mesh);
    visit_links(visit, mesh);
    visit_points(visit, mesh);
    visit_property<Face, FaceTexture>(visit, mesh, property::texture, mesh.faces());
    visit_property<Face, Eigen::Vector3d>(visit, mesh, property::axis, mesh.faces());
    visit_property<Vertex, std::uint32_t>(visit, mesh, property::file_vertex, mesh.vertices());
    visit_property<Vertex, FileWeights>(visit, mesh, property::file_weights, mesh.vertices());
    visit_property<Face, Colour>(visit, mesh, property::face_colour, mesh.faces());
    visit_property<Vertex, Colour>(visit, mesh, property::vertex_colour, mesh.vertices());
    visit_groups(visit, mesh);
    visit_surface_materials(visit, mesh);
}

}  // namespace sherd
