// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/place_vertex.h"

#include <algorithm>
#include <numbers>

#include "meshops/mesh_measures.h"
#include "meshops/trial_choice.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

constexpr double on_side = 1e-9;  // weight of a corner below which a point lies on the opposite side

/// The sides of a face, each from corner i to corner i + 1.
std::array<Halfedge, 3> sides_of(const Mesh& mesh, const std::array<Vertex, 3>& corners) {
    std::array<Halfedge, 3> sides;
    for (int i = 0; i < 3; ++i) sides[i] = mesh.halfedge(corners[i], corners[(i + 1) % 3]);
    return sides;
}

/// Returns the point, or the nearest point on a line of its face if that is within `near` (m).
SurfacePoint drawn_to_lines(const Patch& patch, const SurfacePoint& point, double near) {
    const Vector3d place = position(patch.mesh, point);
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    SurfacePoint drawn = point;
    for (int i = 0; i < 3; ++i) {
        if (!patch.line[patch.mesh.edge(sides[i])]) continue;
        const Vector3d from = position(patch.mesh, point.corners[i]);
        const Vector3d side = position(patch.mesh, point.corners[(i + 1) % 3]) - from;
        const double t = std::clamp((place - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
        const double distance = (place - from - t * side).norm();
        if (distance >= near) continue;
        near = distance;
        drawn.weights.setZero();
        drawn.weights[i] = 1 - t;
        drawn.weights[(i + 1) % 3] = t;
    }
    return drawn;
}

/// Whether a corner of the point's face may be moved there.
bool may_move(const Patch& patch, int corner, const SurfacePoint& point) {
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    const auto is_on_line = [&](int side) {
        return point.weights[(side + 2) % 3] < on_side && patch.line[patch.mesh.edge(sides[side])];
    };
    const Mobility mobility = patch.mobility[point.corners[corner]];
    if (mobility == Mobility::slides) return is_on_line(corner) || is_on_line((corner + 2) % 3);
    return mobility == Mobility::free && !is_on_line(0) && !is_on_line(1) && !is_on_line(2);
}

Candidate moved_corner(const Patch& patch, Vertex corner, const SurfacePoint& point) {
    auto trial = std::make_unique<PatchTrial>(patch);
    trial->move(corner, point);
    trial->fix(corner);
    return plain_candidate(std::move(trial), corner, AdvancedEdge::Way::snapped, 0);
}

Candidate inserted_vertex(const Patch& patch, const SurfacePoint& point) {
    auto trial = std::make_unique<PatchTrial>(patch);
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    Vertex inserted = Mesh::null_vertex();
    for (int i = 0; i < 3 && !inserted.is_valid(); ++i)
        if (point.weights[(i + 2) % 3] < on_side)
            inserted =
                trial->split_edge(sides[i], point.weights[(i + 1) % 3] / (1 - point.weights[(i + 2) % 3]));
    if (!inserted.is_valid()) {
        const Face face = patch.mesh.face(sides[0]);
        const std::array<Vertex, 3> corners = face_corners(patch.mesh, face);
        Vector3d weights;
        for (int i = 0; i < 3; ++i) weights[corner_number(corners, point.corners[i])] = point.weights[i];
        inserted = trial->split_face(face, weights);
    }
    return plain_candidate(std::move(trial), inserted, AdvancedEdge::Way::cut, 0);
}

std::vector<Vertex> centres_at(const Mesh& mesh, const SurfacePoint& point) {
    std::vector<Vertex> centres(point.corners.begin(), point.corners.end());
    for (const Halfedge h : sides_of(mesh, point.corners))
        if (const Halfedge over = mesh.opposite(h); !mesh.is_border(over))
            centres.push_back(mesh.target(mesh.next(over)));
    return centres;
}

}  // namespace

PlacedVertex place_vertex(Mesh& mesh, const SurfacePoint& point, double near, const AdvanceOptions& options) {
    const Patch patch = patch_around(mesh, centres_at(mesh, point), options.kept);
    SurfacePoint local = point;
    for (Vertex& corner : local.corners) corner = patch.local(corner);
    local = drawn_to_lines(patch, local, near);
    const Vector3d place = position(patch.mesh, local);
    std::array<int, 3> order{0, 1, 2};
    const auto distance = [&](int i) { return (position(patch.mesh, local.corners[i]) - place).norm(); };
    std::ranges::sort(order, {}, distance);
    const bool is_free = options.snap && may_move(patch, order[0], local);
    if (distance(order[0]) <= (is_free ? on_side * near : near))
        return {patch.vertices[local.corners[order[0]]], std::numbers::pi, {}};

    std::vector<Candidate> snaps, cuts;
    for (const int i : order)
        if (options.snap && may_move(patch, i, local))
            snaps.push_back(moved_corner(patch, local.corners[i], local));
    cuts.push_back(inserted_vertex(patch, local));
    AdvanceOptions best = options;
    best.always_straight = true;
    const Candidate choice = chosen(std::move(snaps), std::move(cuts), best);
    if (!choice.trial) return {patch.vertices[local.corners[order[0]]], std::numbers::pi, {}};
    PatchTrial::Applied applied = choice.trial->apply(mesh);
    return {applied.vertices[choice.vertex], choice.angle, std::move(applied.change)};
}

}  // namespace sherd
