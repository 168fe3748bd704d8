// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/shell/patch_momentum.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

/// Returns the axis turned into the plane of a face, with the same length. An axis normal to the plane is
/// returned unchanged.
Vector3d in_plane(const Vector3d& axis, const TrianglePositions& rest) {
    const Vector3d normal =
        Vector3d(rest.col(1) - rest.col(0)).cross(Vector3d(rest.col(2) - rest.col(0))).normalized();
    const Vector3d within = axis - normal * normal.dot(axis);
    return within.norm() > 1e-9 * axis.norm() ? Vector3d(axis.norm() * within.normalized()) : axis;
}

std::vector<Index> faces_of(const std::vector<ShellChange::ChangedFace>& changed) {
    std::vector<Index> faces;
    for (const auto& [face, vertices] : changed) faces.push_back(face);
    return faces;
}

std::vector<Index> elements_of(const std::vector<IndexWithParents>& inserted) {
    std::vector<Index> elements;
    for (const IndexWithParents& one : inserted) elements.push_back(one.element);
    return elements;
}

}  // namespace

void BreakableShell::lock_vertices(std::span<const Index> vertices) {
    for (const Index vertex : vertices) shell.kept[vertex] = 1;
}

void BreakableShell::lock_border(std::span<const Index> faces) {
    std::vector<char> inside(mesh().number_of_faces(), 0);
    for (const Index face : faces) inside[face] = 1;
    for (const Edge edge : mesh().edges())
        if (!mesh().is_border(edge) &&
            inside[mesh().face(mesh().halfedge(edge, 0))] != inside[mesh().face(mesh().halfedge(edge, 1))])
            shell.edge_kept[edge] = 1;
}

bool BreakableShell::overlaps_collider(Vertex vertex) const {
    return std::ranges::any_of(shell.start_depths,
                               [&](const StartDepth& start) { return start.depth[vertex] > 0; });
}

bool BreakableShell::is_supported_alone(Vertex vertex) const {
    if (shell.guide[vertex] == 0 && shell.support_set[vertex] == 0) return false;
    return std::ranges::any_of(mesh().halfedges_around_target(mesh().halfedge(vertex)), [&](Halfedge h) {
        const Vertex other = mesh().source(h);
        return shell.guide[vertex] != shell.guide[other] ||
               shell.support_set[vertex] != shell.support_set[other];
    });
}

AdvanceOptions BreakableShell::with_locks(const AdvanceOptions& options) const {
    AdvanceOptions all = options;
    all.kept.is_fixed_vertex = [this, given = options.kept.is_fixed_vertex](Vertex v) {
        return shell.fixed[v] != 0 || shell.script[v] != 0 || shell.kept[v] != 0 ||
               crack_faces.has_coincident(v) || exemptions.has(v) || overlaps_collider(v) ||
               is_supported_alone(v) || given(v);
    };
    all.kept.is_line = [this, given = options.kept.is_line](Edge edge) {
        return shell.edge_kept[edge] != 0 || given(edge);
    };
    return all;
}

std::optional<BreakableShell::Advanced> BreakableShell::advance(Vertex tip, const Vector3d& direction,
                                                                const AdvanceOptions& options) {
    auto edge = crack_mesh.advance(tip, direction, with_locks(options));
    if (!edge) return std::nullopt;
    Advanced advanced{edge->way, edge->halfedge, edge->direction, edge->off_course, {}};
    TopologyChange& topology = advanced.change.cracks.topology = std::move(edge->change);
    if (!topology.reshaped.empty()) advanced.change.shell = reshape(topology);
    return advanced;
}

ShellChange BreakableShell::reshape(const TopologyChange& topology) {
    ShellChange change = shell_change(mesh(), topology, shell);
    const OldSides old(mesh(), topology, shell);
    add_footprints(faces_of(change.changed), &old, -1);
    parents_at_rest.follow(mesh(), topology);
    Positions position = shell.position, velocity = shell.velocity;
    follow(shell, change);
    for (const auto* vertices : {&topology.vertices, &topology.moved})
        for (const WithParents<Vertex>& vertex : *vertices)
            shell.rest.col(static_cast<Index>(vertex.element)) = sherd::position(mesh(), vertex.element);
    for (const IndexWithParents& inserted : change.vertices) shell.footprint[inserted.element] = 0;
    reshape_faces(change);
    reshape_hinges(change);
    add_footprints(elements_of(change.reshaped), nullptr, 1);
    crack_faces.cut(mesh(), topology);
    exemptions.follow(topology);
    write_pairs();
    follow_in_motion(shell, change, position, velocity);
    shell.position = std::move(position);
    shell.velocity = std::move(velocity);
    return change;
}

void BreakableShell::make_unbreakable(Edge edge) {
    shell.edge_strength_factor[edge] = shell.edge_strength[edge] = never;
}

void BreakableShell::reshape_faces(const ShellChange& change) {
    std::vector<double> masses;
    std::vector<Vector3d> axes;
    std::set<Vertex> corners;
    for (const auto& [face, shares] : change.reshaped) {
        double& mass = masses.emplace_back(0);
        for (const auto& [parent, share] : shares) mass += share * shell.face_mass[parent];
        const TrianglePositions rest =
            columns(shell.rest, face_vertices(mesh(), Face(static_cast<unsigned>(face))));
        axes.push_back(in_plane(shell.face_axis[shares.front().element], rest));
    }
    for (std::size_t i = 0; i < change.reshaped.size(); ++i) {
        const Face face(static_cast<unsigned>(change.reshaped[i].element));
        shell.face_mass[face] = masses[i];
        shell.face_axis[face] = axes[i];
        shell.triangles[face] = stencil(face);
        for (const Index vertex : shell.triangles[face].vertices)
            corners.insert(Vertex(static_cast<unsigned>(vertex)));
    }
    for (const Vertex vertex : corners) shell.mass[static_cast<Index>(vertex)] = mass_of_faces(vertex);
}

void BreakableShell::reshape_hinges(ShellChange& change) {
    std::set<Edge> edges;
    for (const IndexWithParents& face : change.reshaped)
        for (const Halfedge h :
             mesh().halfedges_around_face(mesh().halfedge(Face(static_cast<unsigned>(face.element)))))
            if (cracks().state(mesh().edge(h)) == EdgeState::interior) edges.insert(mesh().edge(h));
    for (const Edge edge : edges) {
        Index& hinge = shell.edge_hinge[edge];
        if (hinge < 0) {
            hinge = static_cast<Index>(shell.hinges.size());
            shell.hinges.emplace_back();
            shell.hinge_edge.push_back(static_cast<Index>(edge));
        }
        shell.hinges[hinge] = stencil(edge);
        shell.edge_strength[edge] = strength_of_hinge(edge);
        shell.edge_toughness[edge] = toughness_of_hinge(edge);
        change.reshaped_hinges.push_back(hinge);
    }
    std::ranges::sort(change.reshaped_hinges);
}

/// Adds (sign 1) to the contact areas of corners, or subtracts from them (sign -1), the contributions of
/// faces and of the faces' sides on the outline. old: finds the edges between the faces' corners if the faces
/// belong to the mesh before its change; null: the faces belong to the present mesh.
void BreakableShell::add_footprints(std::span<const Index> faces, const OldSides* old, double sign) {
    const auto edge_between = [&](Index from, Index to) {
        if (old != nullptr) return old->between(from, to);
        return mesh().edge(
            mesh().halfedge(Vertex(static_cast<unsigned>(from)), Vertex(static_cast<unsigned>(to))));
    };
    for (const Index face : faces) {
        const auto& [vertices, membrane] = shell.triangles[face];
        for (int i = 0; i < 3; ++i) {
            const Index from = vertices[i], to = vertices[(i + 1) % 3];
            shell.footprint[from] += sign * membrane.area / 3;
            const Edge edge = edge_between(from, to);
            if (!edge.is_valid() || !cracks().is_outline(edge)) continue;
            const double rim = 0.5 * (shell.rest.col(from) - shell.rest.col(to)).norm();
            for (const Index end : {from, to}) shell.footprint[end] += sign * rim * shell.thickness[end];
        }
    }
}

}  // namespace sherd
