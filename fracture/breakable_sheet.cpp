// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/breakable_sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <string>
#include <tuple>

#include "meshops/error.h"

namespace sherd {
namespace {

Vector3d vector_of(const Point& point) {
    return {point.x(), point.y(), point.z()};
}

Index number(std::size_t element) {
    return static_cast<Index>(element);
}

std::array<Index, 3> face_vertices(const Mesh& mesh, Face face) {
    std::array<Index, 3> vertices;
    Halfedge h = mesh.halfedge(face);
    for (Index& vertex : vertices) {
        vertex = number(mesh.target(h));
        h = mesh.next(h);
    }
    return vertices;
}

Mesh joined(const std::vector<SheetInput>& inputs) {
    Mesh all = inputs.front().mesh;
    for (std::size_t i = 1; i < inputs.size(); ++i) all.join(inputs[i].mesh);
    return all;
}

/// The first material axis of every face of all sheets, [F]; zero, an angle of nought, where it does not
/// matter.
std::vector<Vector3d> joined_axes(const std::vector<SheetInput>& inputs) {
    std::vector<Vector3d> all;
    for (const SheetInput& input : inputs) {
        const std::string number = std::to_string(&input - inputs.data());
        if (const std::string broken = broken_inequality(elastic_constants(input.material)); !broken.empty())
            throw Error("sheet " + number + ": inadmissible material: " + broken);
        const std::size_t faces = input.mesh.number_of_faces();
        const bool directed = !is_isotropic(input.material) || input.strength.along != input.strength.across;
        if (input.axes.size() != faces && (directed || !input.axes.empty()))
            throw Error("sheet " + number +
                        ": a material or a strength with directions needs an axis for each of " +
                        std::to_string(faces) + " faces, not " + std::to_string(input.axes.size()));
        all.insert(all.end(), input.axes.begin(), input.axes.end());
        if (input.axes.empty()) all.resize(all.size() + faces, Vector3d::Zero());
    }
    return all;
}

}  // namespace

BreakableSheet::BreakableSheet(const std::vector<SheetInput>& inputs) : crack_mesh(joined(inputs)) {
    Index first_vertex = 0;
    for (const SheetInput& input : inputs) {
        add_vertices(input, number(&input - inputs.data()), first_vertex);
        sheet_of_face.insert(sheet_of_face.end(), input.mesh.number_of_faces(),
                             number(&input - inputs.data()));
        first_vertex += number(input.mesh.number_of_vertices());
    }
    add_coincident_vertices();
    const std::vector<Vector3d> axes = joined_axes(inputs);
    add_triangles(inputs, axes);
    add_hinges(inputs, axes);
    add_strengths(inputs);
    add_footprints();
    first_vertex = 0;
    for (const SheetInput& input : inputs) {
        set_rigid_motion(input, first_vertex);
        first_vertex += number(input.mesh.number_of_vertices());
    }
}

void BreakableSheet::add_vertices(const SheetInput& input, Index body, Index first_vertex) {
    resize_vertices(sheet, first_vertex + number(input.mesh.number_of_vertices()));
    for (const Vertex vertex : input.mesh.vertices()) {
        const Index v = first_vertex + number(vertex);
        sheet.rest.col(v) = sheet.position.col(v) = vector_of(input.mesh.point(vertex));
        sheet.thickness[v] = input.material.thickness;
        sheet.young[v] = mean_young(input.material);
        sheet.body[v] = body;
    }
    for (const Index pinned : input.pinned) sheet.fixed[first_vertex + pinned] = 1;
    for (const MovingPin& pin : input.moving_pins) {
        sheet.motions.push_back(pin.motion);
        for (const Index v : pin.vertices) sheet.carrier[first_vertex + v] = number(sheet.motions.size());
    }
}

void BreakableSheet::add_coincident_vertices() {
    using Place = std::tuple<Index, double, double, double>;
    std::map<Place, std::vector<Vertex>> at_place;
    for (const Vertex vertex : mesh().vertices()) {
        const Vector3d at = sheet.rest.col(number(vertex));
        std::vector<Vertex>& others = at_place[{sheet.body[number(vertex)], at.x(), at.y(), at.z()}];
        for (const Vertex other : others) lips.lie_together(other, vertex);
        others.push_back(vertex);
    }
    lips.write(mesh(), sheet);
}

void BreakableSheet::add_triangles(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes) {
    for (const Face face : mesh().faces()) {
        const Material& material = inputs[sheet_of_face[face]].material;
        const std::array<Index, 3> vertices = face_vertices(mesh(), face);
        const TrianglePositions rest = columns(sheet.rest, vertices);
        const MembraneTriangle membrane =
            membrane_triangle(rest, membrane_elasticity(material, axis_angle(rest, axes[face])));
        sheet.triangles.push_back({vertices, membrane});
        face_area.push_back(membrane.area);
        face_mass.push_back(membrane.area * material.thickness * material.density);
        for (const Index vertex : vertices) sheet.mass[vertex] += face_mass.back() / 3;
    }
}

void BreakableSheet::add_hinges(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes) {
    for (const Edge edge : mesh().edges()) {
        edge_hinge.push_back(-1);
        edge_strength.push_back(std::numeric_limits<double>::infinity());
        if (cracks().state(edge) != EdgeState::interior) continue;
        const std::array<Face, 2> faces{mesh().face(mesh().halfedge(edge, 0)),
                                        mesh().face(mesh().halfedge(edge, 1))};
        const SheetInput& input = inputs[sheet_of_face[faces[0]]];
        edge_hinge.back() = number(sheet.hinges.size());
        hinge_edge.push_back(edge);
        const std::array<Index, 4> vertices = hinge_vertices(edge);
        const double angle =
            hinge_axis_angle(columns(sheet.rest, vertices), {axes[faces[0]], axes[faces[1]]});
        edge_strength.back() = directional_strength(input.strength, angle);
        sheet.hinges.push_back(hinge_stencil(sheet, vertices, hinge_stiffness(input.material, angle)));
    }
}

void BreakableSheet::add_strengths(const std::vector<SheetInput>& inputs) {
    std::size_t first_edge = 0;
    for (const SheetInput& input : inputs) {
        const std::vector<double>& factors = input.strength.factors;
        const std::size_t edges = input.mesh.number_of_edges();
        if (!factors.empty() && factors.size() != edges)
            throw Error("sheet " + std::to_string(&input - inputs.data()) + ": " +
                        std::to_string(factors.size()) + " factors of the strength for " +
                        std::to_string(edges) + " edges");
        for (std::size_t e = 0; e < factors.size(); ++e) edge_strength[first_edge + e] *= factors[e];
        first_edge += edges;
        measures.push_back(input.strength.measure);
        crack_tip_factors.push_back(input.strength.crack_tip_factor);
    }
}

Index BreakableSheet::sheet_of(Edge edge) const {
    const Halfedge h = mesh().halfedge(edge);
    return sheet_of_face[mesh().face(mesh().is_border(h) ? mesh().opposite(h) : h)];
}

void BreakableSheet::add_footprints() {
    for (const TriangleStencil& triangle : sheet.triangles)
        for (const Index vertex : triangle.vertices) sheet.footprint[vertex] += triangle.membrane.area / 3;
    for (const Edge edge : mesh().edges()) {
        if (!mesh().is_border(edge)) continue;
        const Index a = number(mesh().vertex(edge, 0)), b = number(mesh().vertex(edge, 1));
        const double rim = 0.5 * (sheet.rest.col(a) - sheet.rest.col(b)).norm();
        for (const Index end : {a, b}) sheet.footprint[end] += rim * sheet.thickness[end];
    }
}

void BreakableSheet::set_rigid_motion(const SheetInput& input, Index first_vertex) {
    const Index count = number(input.mesh.number_of_vertices());
    const VectorXd mass = sheet.mass.segment(first_vertex, count);
    const Vector3d centre = sheet.position.middleCols(first_vertex, count) * mass / mass.sum();
    for (Index v = first_vertex; v < first_vertex + count; ++v)
        if (!sheet.fixed[v])
            sheet.velocity.col(v) =
                input.velocity + input.spin.cross(Vector3d(sheet.position.col(v)) - centre);
}

std::array<Index, 4> BreakableSheet::hinge_vertices(Edge edge) const {
    const Halfedge h = mesh().halfedge(edge, 0), other = mesh().opposite(h);
    return {number(mesh().source(h)), number(mesh().target(h)), number(mesh().target(mesh().next(h))),
            number(mesh().target(mesh().next(other)))};
}

BreakableSheet::Change BreakableSheet::fail(std::span<const Edge> edges) {
    Change change{crack_mesh.fail(edges), {}};
    const Opening& opening = change.cracks.opening;
    for (const Edge edge : edges) change.shell.removed_hinges.push_back(remove_hinge(edge));
    edge_hinge.resize(mesh().number_of_edges(), -1);
    edge_strength.resize(mesh().number_of_edges(), std::numeric_limits<double>::infinity());
    for (const auto& [vertex, created] : opening.vertices)
        change.shell.vertices.push_back({number(vertex), number(created)});
    carry_over(opening);
    renumber(opening.faces);
    share_masses(opening);
    lips.open(opening);
    lips.write(mesh(), sheet);
    return change;
}

bool BreakableSheet::release_lips() {
    if (!lips.release(mesh(), sheet, sheet.position)) return false;
    lips.write(mesh(), sheet);
    return true;
}

Index BreakableSheet::remove_hinge(Edge edge) {
    const Index hinge = edge_hinge[edge];
    edge_hinge[hinge_edge.back()] = hinge;
    edge_hinge[edge] = -1;
    hinge_edge[hinge] = hinge_edge.back();
    hinge_edge.pop_back();
    sheet.hinges[hinge] = sheet.hinges.back();
    sheet.hinges.pop_back();
    return hinge;
}

void BreakableSheet::carry_over(const Opening& opening) {
    resize_vertices(sheet, number(mesh().number_of_vertices()));
    for (const auto& [vertex, created] : opening.vertices)
        copy_vertex(sheet, number(vertex), number(created));
}

void BreakableSheet::renumber(std::span<const Face> faces) {
    for (const Face face : faces) {
        sheet.triangles[face].vertices = face_vertices(mesh(), face);
        for (const Halfedge h : mesh().halfedges_around_face(mesh().halfedge(face))) {
            const Index hinge = edge_hinge[mesh().edge(h)];
            if (hinge >= 0) sheet.hinges[hinge].vertices = hinge_vertices(mesh().edge(h));
        }
    }
}

void BreakableSheet::share_masses(const Opening& opening) {
    const auto rest_mass = [this](Vertex vertex) {
        double sum = 0;
        for (const Face face : mesh().faces_around_target(mesh().halfedge(vertex)))
            if (face != Mesh::null_face()) sum += face_mass[face] / 3;
        return sum;
    };
    for (std::size_t i = 0; i < opening.vertices.size();) {
        const Vertex vertex = opening.vertices[i].vertex;
        std::vector<Vertex> copies{vertex};
        for (; i < opening.vertices.size() && opening.vertices[i].vertex == vertex; ++i)
            copies.push_back(opening.vertices[i].created);
        const double footprint_per_mass = sheet.footprint[vertex] / sheet.mass[vertex];
        for (const Vertex copy : copies) {
            sheet.mass[copy] = rest_mass(copy);
            sheet.footprint[copy] = footprint_per_mass * sheet.mass[copy];
        }
    }
}

}  // namespace sherd
