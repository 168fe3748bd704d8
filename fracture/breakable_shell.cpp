// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/breakable_shell.h"

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

template <class Element>
std::vector<Heir> heirs(const std::vector<Born<Element>>& born) {
    std::vector<Heir> all;
    for (const auto& [element, parents] : born) {
        all.push_back({number(element), {}});
        for (const auto& [parent, weight] : parents) all.back().parents.push_back({number(parent), weight});
    }
    return all;
}

Mesh joined(const std::vector<SheetInput>& inputs) {
    Mesh all = inputs.front().mesh;
    for (std::size_t i = 1; i < inputs.size(); ++i) all.join(inputs[i].mesh);
    return all;
}

/// The first material axis of every face of all sheets, [F]; where it does not matter it is zero, which
/// stands for an angle of zero.
std::vector<Vector3d> joined_axes(const std::vector<SheetInput>& inputs) {
    std::vector<Vector3d> all;
    for (const SheetInput& input : inputs) {
        const std::string number = std::to_string(&input - inputs.data());
        if (const std::string broken = broken_inequality(elastic_constants(input.material)); !broken.empty())
            throw Error("sheet " + number + ": inadmissible material: " + broken);
        const std::size_t faces = input.mesh.number_of_faces();
        const bool directed = !is_isotropic(input.material) ||
                              input.strength.along != input.strength.across ||
                              input.toughness.has_directions();
        if (input.axes.size() != faces && (directed || !input.axes.empty()))
            throw Error("sheet " + number +
                        ": a material, a strength or a toughness with directions needs an axis for each of " +
                        std::to_string(faces) + " faces, not " + std::to_string(input.axes.size()));
        all.insert(all.end(), input.axes.begin(), input.axes.end());
        if (input.axes.empty()) all.resize(all.size() + faces, Vector3d::Zero());
    }
    return all;
}

}  // namespace

BreakableShell::BreakableShell(const std::vector<SheetInput>& inputs) : crack_mesh(joined(inputs)) {
    Index first_vertex = 0;
    for (const SheetInput& input : inputs) {
        add_vertices(input, number(&input - inputs.data()), first_vertex);
        shell.face_sheet.insert(shell.face_sheet.end(), input.mesh.number_of_faces(),
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

void BreakableShell::add_vertices(const SheetInput& input, Index sheet, Index first_vertex) {
    resize_vertices(shell, first_vertex + number(input.mesh.number_of_vertices()));
    for (const Vertex vertex : input.mesh.vertices()) {
        const Index v = first_vertex + number(vertex);
        shell.rest.col(v) = shell.position.col(v) = vector_of(input.mesh.point(vertex));
        shell.thickness[v] = input.material.thickness;
        shell.young[v] = mean_young(input.material);
        shell.vertex_sheet[v] = sheet;
    }
    for (const Index pinned : input.pinned) shell.fixed[first_vertex + pinned] = 1;
    for (const MovingPin& pin : input.moving_pins) {
        shell.motions.push_back(pin.motion);
        for (const Index v : pin.vertices) shell.script[first_vertex + v] = number(shell.motions.size());
    }
}

void BreakableShell::add_coincident_vertices() {
    using Place = std::tuple<Index, double, double, double>;
    std::map<Place, std::vector<Vertex>> at_place;
    for (const Vertex vertex : mesh().vertices()) {
        const Vector3d at = shell.rest.col(number(vertex));
        std::vector<Vertex>& others = at_place[{shell.vertex_sheet[number(vertex)], at.x(), at.y(), at.z()}];
        for (const Vertex other : others) lips.lie_together(other, vertex);
        others.push_back(vertex);
    }
    lips.write(mesh(), shell);
}

void BreakableShell::add_triangles(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes) {
    for (const Face face : mesh().faces()) {
        const Material& material = inputs[shell.face_sheet[face]].material;
        const std::array<Index, 3> vertices = face_vertices(mesh(), face);
        const TrianglePositions rest = columns(shell.rest, vertices);
        const MembraneTriangle membrane =
            membrane_triangle(rest, membrane_elasticity(material, axis_angle(rest, axes[face])));
        shell.triangles.push_back({vertices, membrane});
        shell.face_mass.push_back(membrane.area * material.thickness * material.density);
        for (const Index vertex : vertices) shell.mass[vertex] += shell.face_mass.back() / 3;
    }
}

void BreakableShell::add_hinges(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes) {
    for (const Edge edge : mesh().edges()) {
        shell.edge_hinge.push_back(-1);
        shell.edge_strength.push_back(never);
        shell.edge_toughness.push_back(0);
        if (cracks().state(edge) != EdgeState::interior) continue;
        const std::array<Face, 2> faces{mesh().face(mesh().halfedge(edge, 0)),
                                        mesh().face(mesh().halfedge(edge, 1))};
        const SheetInput& input = inputs[shell.face_sheet[faces[0]]];
        shell.edge_hinge.back() = number(shell.hinges.size());
        shell.hinge_edge.push_back(number(edge));
        const std::array<Index, 4> vertices = hinge_vertices(edge);
        const double angle =
            hinge_axis_angle(columns(shell.rest, vertices), {axes[faces[0]], axes[faces[1]]});
        shell.edge_strength.back() = directional_strength(input.strength, angle);
        shell.edge_toughness.back() = directional_toughness(input.toughness, angle);
        shell.hinges.push_back(hinge_stencil(shell, vertices, hinge_stiffness(input.material, angle)));
    }
}

void BreakableShell::add_strengths(const std::vector<SheetInput>& inputs) {
    std::size_t first_edge = 0;
    for (const SheetInput& input : inputs) {
        const std::size_t edges = input.mesh.number_of_edges();
        const auto multiply = [&](std::vector<double>& values, const std::vector<double>& factors,
                                  const char* of) {
            if (!factors.empty() && factors.size() != edges)
                throw Error("sheet " + std::to_string(&input - inputs.data()) + ": " +
                            std::to_string(factors.size()) + " factors of the " + of + " for " +
                            std::to_string(edges) + " edges");
            for (std::size_t e = 0; e < factors.size(); ++e) values[first_edge + e] *= factors[e];
        };
        multiply(shell.edge_strength, input.strength.factors, "strength");
        multiply(shell.edge_toughness, input.toughness.factors, "toughness");
        first_edge += edges;
        measures.push_back(input.strength.measure);
        crack_tip_factors.push_back(input.toughness.given() ? 1 : input.strength.crack_tip_factor);
        directed.push_back(input.strength.along != input.strength.across);
        toughnesses.push_back(input.toughness);
        art_directions.push_back(input.art_direction);
    }
    set_time(0);
}

void BreakableShell::set_time(double now) {
    time = now;
    some_wait = std::ranges::any_of(art_directions, [&](const ArtDirection& one) { return now < one.after; });
}

std::vector<double> BreakableShell::face_areas() const {
    std::vector<double> areas;
    for (const TriangleStencil& triangle : shell.triangles) areas.push_back(triangle.membrane.area);
    return areas;
}

Index BreakableShell::sheet_of(Edge edge) const {
    const Halfedge h = mesh().halfedge(edge);
    return shell.face_sheet[mesh().face(mesh().is_border(h) ? mesh().opposite(h) : h)];
}

void BreakableShell::add_footprints() {
    for (const TriangleStencil& triangle : shell.triangles)
        for (const Index vertex : triangle.vertices) shell.footprint[vertex] += triangle.membrane.area / 3;
    for (const Edge edge : mesh().edges()) {
        if (!mesh().is_border(edge)) continue;
        const Index a = number(mesh().vertex(edge, 0)), b = number(mesh().vertex(edge, 1));
        const double rim = 0.5 * (shell.rest.col(a) - shell.rest.col(b)).norm();
        for (const Index end : {a, b}) shell.footprint[end] += rim * shell.thickness[end];
    }
}

void BreakableShell::set_rigid_motion(const SheetInput& input, Index first_vertex) {
    const Index count = number(input.mesh.number_of_vertices());
    const VectorXd mass = shell.mass.segment(first_vertex, count);
    const Vector3d centre = shell.position.middleCols(first_vertex, count) * mass / mass.sum();
    for (Index v = first_vertex; v < first_vertex + count; ++v)
        if (!shell.fixed[v])
            shell.velocity.col(v) =
                input.velocity + input.spin.cross(Vector3d(shell.position.col(v)) - centre);
}

std::array<Index, 4> BreakableShell::hinge_vertices(Edge edge) const {
    const Halfedge h = mesh().halfedge(edge, 0), other = mesh().opposite(h);
    return {number(mesh().source(h)), number(mesh().target(h)), number(mesh().target(mesh().next(h))),
            number(mesh().target(mesh().next(other)))};
}

BreakableShell::Change BreakableShell::fail(std::span<const Edge> edges) {
    Change change{crack_mesh.fail(edges), {}};
    const TopologyChange& topology = change.cracks.topology;
    for (const Edge edge : edges) change.shell.removed_hinges.push_back(remove_hinge_of(shell, number(edge)));
    change.shell.vertices = heirs(topology.vertices);
    change.shell.edges = heirs(topology.edges);
    change.shell.faces = heirs(topology.faces);
    follow(shell, change.shell);
    renumber(topology.changed);
    share_masses(topology);
    lips.open(topology);
    lips.write(mesh(), shell);
    return change;
}

bool BreakableShell::release_lips() {
    if (!lips.release(mesh(), shell, shell.position)) return false;
    lips.write(mesh(), shell);
    return true;
}

void BreakableShell::renumber(std::span<const Face> faces) {
    for (const Face face : faces) {
        shell.triangles[face].vertices = face_vertices(mesh(), face);
        for (const Halfedge h : mesh().halfedges_around_face(mesh().halfedge(face))) {
            const Index hinge = shell.edge_hinge[mesh().edge(h)];
            if (hinge >= 0) shell.hinges[hinge].vertices = hinge_vertices(mesh().edge(h));
        }
    }
}

void BreakableShell::share_masses(const TopologyChange& change) {
    const auto rest_mass = [this](Vertex vertex) {
        double sum = 0;
        for (const Face face : mesh().faces_around_target(mesh().halfedge(vertex)))
            if (face != Mesh::null_face()) sum += shell.face_mass[face] / 3;
        return sum;
    };
    const auto share = [&](Vertex vertex, double footprint_per_mass) {
        shell.mass[number(vertex)] = rest_mass(vertex);
        shell.footprint[number(vertex)] = footprint_per_mass * shell.mass[number(vertex)];
    };
    Vertex shared;  // the original vertex whose copies are being processed; they are consecutive
    double footprint_per_mass = 0;
    for (const Born<Vertex>& copy : change.vertices) {
        if (copy.parent() != shared) {
            shared = copy.parent();
            footprint_per_mass = shell.footprint[number(shared)] / shell.mass[number(shared)];
            share(shared, footprint_per_mass);
        }
        share(copy.element, footprint_per_mass);
    }
}

}  // namespace sherd
