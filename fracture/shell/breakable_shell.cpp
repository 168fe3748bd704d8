// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/breakable_shell.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "meshops/attributes.h"
#include "meshops/error.h"

namespace sherd {
namespace {

Vector3d vector_of(const Point& point) {
    return {point.x(), point.y(), point.z()};
}

Index number(std::size_t element) {
    return static_cast<Index>(element);
}

Mesh joined(const std::vector<SheetInput>& inputs) {
    Mesh all = inputs.front().mesh;
    // Mesh::join() copies only the properties that `all` has.
    for (const SheetInput& input : inputs) take_properties(all, input.mesh);
    for (std::size_t i = 1; i < inputs.size(); ++i) all.join(inputs[i].mesh);
    return all;
}

/// Returns the first material axis of every face of all sheets, [F]. If no property of a sheet depends on the
/// direction, its axes may be missing: they are then zero vectors, which stand for an angle of zero. Throws
/// Error if a material is inadmissible or an axis is missing.
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

BreakableShell::BreakableShell(const std::vector<SheetInput>& inputs)
    : crack_mesh(joined(inputs)), parents_at_rest(mesh()) {
    Index first_vertex = 0;
    for (const SheetInput& input : inputs) {
        require_thickness(input, &input - inputs.data());
        add_vertices(input, number(&input - inputs.data()), first_vertex);
        shell.face_sheet.insert(shell.face_sheet.end(), input.mesh.number_of_faces(),
                                number(&input - inputs.data()));
        first_vertex += number(input.mesh.number_of_vertices());
    }
    add_coincident_vertices();
    shell.face_axis = joined_axes(inputs);
    add_strengths(inputs);
    add_triangles();
    add_hinges();
    add_footprints();
    shell.edge_kept.assign(mesh().number_of_edges(), 0);
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
        shell.rest.col(v) = vector_of(input.mesh.point(vertex));
        shell.position.col(v) = input.starts_at(vertex);
        shell.thickness[v] = input.thickness_at(vertex);
        shell.young[v] = mean_young(input.material);
        shell.vertex_sheet[v] = sheet;
    }
    if (!input.thickness.empty()) shell.uneven = true;
    for (const Index pinned : input.pinned) shell.fixed[first_vertex + pinned] = 1;
    for (const MovingPin& pin : input.moving_pins) {
        shell.motions.push_back(pin.motion);
        for (const Index v : pin.vertices) shell.script[first_vertex + v] = number(shell.motions.size());
    }
}

void BreakableShell::add_coincident_vertices() {
    const auto place = [this](Vertex vertex) {
        const Vector3d at = shell.rest.col(number(vertex));
        return std::tuple(shell.vertex_sheet[number(vertex)], at.x(), at.y(), at.z());
    };
    std::vector<Vertex> by_place(mesh().vertices().begin(), mesh().vertices().end());
    std::ranges::stable_sort(by_place, {}, place);
    std::vector<std::array<Vertex, 2>> pairs;  // the later vertex first
    for (auto first = by_place.begin(); first != by_place.end();) {
        auto last = first + 1;
        for (; last != by_place.end() && place(*last) == place(*first); ++last)
            for (auto other = first; other != last; ++other) pairs.push_back({*last, *other});
        first = last;
    }
    std::ranges::sort(pairs);
    for (const auto& [vertex, other] : pairs) crack_faces.mark_coincident(other, vertex);
    write_pairs();
}

void BreakableShell::visit_state(StateVisitor& visit) {
    auto& [crack_mesh, shell, parents_at_rest, crack_faces, exemptions, materials, strengths, toughnesses,
           art_directions, waiting] = *this;
    visit(crack_mesh, shell, parents_at_rest, crack_faces, exemptions, waiting);
}

TriangleStencil BreakableShell::stencil(Face face) const {
    const std::array<Index, 3> vertices = face_vertices(mesh(), face);
    const TrianglePositions rest = columns(shell.rest, vertices);
    const Material material = material_of(shell.face_sheet[face], vertices);
    return {vertices,
            membrane_triangle(rest, membrane_elasticity(material, axis_angle(rest, shell.face_axis[face])))};
}

void BreakableShell::add_triangles() {
    for (const Face face : mesh().faces()) {
        shell.triangles.push_back(stencil(face));
        const Material material = material_of(face);
        const auto& [vertices, membrane] = shell.triangles.back();
        shell.face_mass.push_back(membrane.area * material.thickness * material.density);
        for (const Index vertex : vertices) shell.mass[vertex] += shell.face_mass.back() / 3;
    }
}

/// Angle from the edge of a hinge to the first material axis, rad: see hinge_axis_angle().
double BreakableShell::hinge_axis(Edge edge) const {
    const auto axis = [&](int side) { return shell.face_axis[mesh().face(mesh().halfedge(edge, side))]; };
    return hinge_axis_angle(columns(shell.rest, hinge_vertices(edge)), {axis(0), axis(1)});
}

HingeStencil BreakableShell::stencil(Edge edge) const {
    const std::array<Index, 4> vertices = hinge_vertices(edge);
    const double stiffness = hinge_stiffness(material_of(sheet_of(edge), vertices), hinge_axis(edge));
    return hinge_stencil(shell, vertices, stiffness);
}

double BreakableShell::strength_of_hinge(Edge edge) const {
    const Strength& strength = strengths[sheet_of(edge)];
    const double itself = directional_strength(strength, hinge_axis(edge)) * shell.edge_strength_factor[edge];
    return strength.measure == Measure::stress ? itself + materials[sheet_of(edge)].tempered : itself;
}

double BreakableShell::toughness_of_hinge(Edge edge) const {
    return directional_toughness(toughnesses[sheet_of(edge)], hinge_axis(edge)) *
           shell.edge_toughness_factor[edge];
}

void BreakableShell::add_hinges() {
    for (const Edge edge : mesh().edges()) {
        shell.edge_hinge.push_back(-1);
        shell.edge_strength.push_back(never);
        shell.edge_toughness.push_back(0);
        if (cracks().state(edge) != EdgeState::interior) continue;
        shell.edge_hinge.back() = number(shell.hinges.size());
        shell.hinge_edge.push_back(number(edge));
        shell.edge_strength.back() = strength_of_hinge(edge);
        shell.edge_toughness.back() = toughness_of_hinge(edge);
        shell.hinges.push_back(stencil(edge));
    }
}

void BreakableShell::add_strengths(const std::vector<SheetInput>& inputs) {
    for (const SheetInput& input : inputs) {
        const std::size_t edges = input.mesh.number_of_edges();
        const auto take = [&](std::vector<double>& factors, const std::vector<double>& given,
                              const char* of) {
            if (!given.empty() && given.size() != edges)
                throw Error("sheet " + std::to_string(&input - inputs.data()) + ": " +
                            std::to_string(given.size()) + " factors of the " + of + " for " +
                            std::to_string(edges) + " edges");
            factors.insert(factors.end(), given.begin(), given.end());
            if (given.empty()) factors.resize(factors.size() + edges, 1);
        };
        take(shell.edge_strength_factor, input.strength.factors, "strength");
        take(shell.edge_toughness_factor, input.toughness.factors, "toughness");
        materials.push_back(input.material);
        strengths.push_back(input.strength);
        strengths.back().factors.clear();
        toughnesses.push_back(input.toughness);
        toughnesses.back().factors.clear();
        art_directions.push_back(input.art_direction);
    }
    hold_back(0);
}

void BreakableShell::hold_back(double time) {
    waiting.clear();
    for (const ArtDirection& sheet : art_directions) waiting.push_back(time < sheet.after);
    if (std::ranges::count(waiting, 1) == 0) waiting.clear();
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

double BreakableShell::toughness_towards(Vertex from, const Vector3d& direction) const {
    double nearest = 0, found = never;
    for (const Halfedge h : mesh().halfedges_around_target(mesh().halfedge(from))) {
        const Edge edge = mesh().edge(h);
        const Vector3d way = shell.rest.col(number(mesh().source(h))) - shell.rest.col(number(from));
        const double along = way.dot(direction) / way.norm();
        if (along <= nearest || !can_fail(edge)) continue;
        nearest = along;
        const Vector3d& axis = shell.face_axis[mesh().face(mesh().is_border(h) ? mesh().opposite(h) : h)];
        const double angle = std::atan2(axis.cross(direction).norm(), axis.dot(direction));
        found = directional_toughness(toughnesses[sheet_of(edge)], angle) * shell.edge_toughness_factor[edge];
    }
    return found;
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
    change.shell = shell_change(mesh(), topology, shell);
    for (const Edge edge : edges) change.shell.removed_hinges.push_back(remove_hinge_of(shell, number(edge)));
    follow(shell, change.shell);
    parents_at_rest.follow(mesh(), topology);
    renumber(topology.changed);
    share_masses(topology);
    crack_faces.open(topology);
    exemptions.follow(topology);
    write_pairs();
    return change;
}

void BreakableShell::exempt(std::span<const StartOverlap> overlaps) {
    exemptions.add(mesh(), overlaps);
    write_pairs();
}

bool BreakableShell::release_apart() {
    const bool of_crack_faces = crack_faces.release(mesh(), shell, shell.position);
    const bool of_start = exemptions.release(mesh(), shell);
    if (!of_crack_faces && !of_start) return false;
    write_pairs();
    return true;
}

void BreakableShell::write_pairs() {
    shell.exempt_pairs.clear();
    crack_faces.write(mesh(), shell);
    exemptions.write(shell);
    std::ranges::sort(shell.exempt_pairs);
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

double BreakableShell::mass_of_faces(Vertex vertex) const {
    double sum = 0;
    for (const Face face : mesh().faces_around_target(mesh().halfedge(vertex)))
        if (face != Mesh::null_face()) sum += shell.face_mass[face] / 3;
    return sum;
}

void BreakableShell::share_masses(const TopologyChange& change) {
    const auto share = [&](Vertex vertex, double footprint_per_mass) {
        shell.mass[number(vertex)] = mass_of_faces(vertex);
        shell.footprint[number(vertex)] = footprint_per_mass * shell.mass[number(vertex)];
    };
    Vertex shared;  // the vertex whose copies are being processed; they are consecutive
    double footprint_per_mass = 0;
    for (const WithParents<Vertex>& copy : change.vertices) {
        if (copy.parent() != shared) {
            shared = copy.parent();
            footprint_per_mass = shell.footprint[number(shared)] / shell.mass[number(shared)];
            share(shared, footprint_per_mass);
        }
        share(copy.element, footprint_per_mass);
    }
}

}  // namespace sherd
