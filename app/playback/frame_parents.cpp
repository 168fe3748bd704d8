// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/frame_parents.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include "core/elements/membrane.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Finds where faces and vertices of the later frame's mesh lie in the earlier frame's mesh, by positions at
/// rest. R is the number of the earlier frame's vertices at rest.
class Parts {
  public:
    Parts(const Snapshot& earlier, const Snapshot& later);

    bool is_unchanged(std::size_t face) const {
        return face < earlier.faces.size() && earlier.rest.faces[face] == later.rest.faces[face] &&
               std::ranges::all_of(later.rest.faces[face], [this](Index v) { return stays(v); });
    }
    /// Returns the earlier face that contains the centroid of the later face `face`, or, if none does, comes
    /// nearest to containing it. Throws Error if there is no candidate.
    Index whole_of(std::size_t face);
    /// Returns the earlier vertex that a corner of the later face `face` was. whole: whole_of(face). Returns
    /// -1 if the vertex was inserted since then or has moved at rest, or if several earlier vertices, on the
    /// sides of a crack, are there and `whole` has none of them.
    Index same_vertex(std::size_t face, int corner, Index whole) const;
    /// Returns the earlier face that contains a corner of the later face `face`, and the corner's barycentric
    /// coordinates in it. The earlier face is `whole`, which is whole_of(face), or one of its neighbours in
    /// the same fragment.
    std::pair<Index, Vector3d> place(std::size_t face, int corner, Index whole) const;

  private:
    using Part = std::pair<Index, Index>;  ///< a face of the unfractured mesh, and an earlier face in it

    /// Whether a vertex at rest of the later frame is also in the earlier frame, in the same position.
    bool stays(Index vertex) const {
        return vertex < earlier.rest.position.cols() &&
               earlier.rest.position.col(vertex) == later.rest.position.col(vertex);
    }
    bool any_mixed() const { return !earlier.rest.face_mixed.empty() || !later.rest.face_mixed.empty(); }
    std::vector<Index> parts_of(const std::set<Index>& unbroken) const;
    std::vector<Index> nearest_parts(Index unbroken) const;
    Vector3d coordinates(Index face, const Vector3d& point) const;
    Vector3d corner_place(std::size_t face, int corner) const {
        return later.rest.position.col(later.rest.faces[face][corner]);
    }

    const Snapshot &earlier, &later;
    std::vector<Part> parts;                       ///< ascending
    std::vector<std::vector<Index>> of_vertex;     ///< [R] earlier vertices of each vertex at rest
    std::vector<std::vector<Index>> faces_around;  ///< [R] earlier faces around each vertex at rest
};

Parts::Parts(const Snapshot& earlier, const Snapshot& later)
    : earlier(earlier),
      later(later),
      of_vertex(earlier.rest.position.cols()),
      faces_around(earlier.rest.position.cols()) {
    for (std::size_t v = 0; v < earlier.original.size(); ++v)
        of_vertex[earlier.original[v]].push_back(static_cast<Index>(v));
    for (std::size_t f = 0; f < earlier.faces.size(); ++f) {
        parts.emplace_back(earlier.rest.face_parent[f], static_cast<Index>(f));
        for (const Index v : earlier.rest.faces[f]) faces_around[v].push_back(static_cast<Index>(f));
    }
    std::ranges::sort(parts);
}

/// Returns the barycentric coordinates in an earlier face at rest of a point (m), projected into the face's
/// plane.
Vector3d Parts::coordinates(Index face, const Vector3d& point) const {
    const TrianglePositions x = columns(earlier.rest.position, earlier.rest.faces[face]);
    const Vector3d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0), way = point - x.col(0),
                   normal = a.cross(b);
    const double second = way.cross(b).dot(normal) / normal.squaredNorm(),
                 third = a.cross(way).dot(normal) / normal.squaredNorm();
    return {1 - second - third, second, third};
}

/// Returns the earlier faces that are parts of the faces `unbroken` of the unfractured mesh.
std::vector<Index> Parts::parts_of(const std::set<Index>& unbroken) const {
    std::vector<Index> found;
    for (const Index face : unbroken)
        for (auto part = std::ranges::lower_bound(parts, Part(face, 0));
             part != parts.end() && part->first == face; ++part)
            found.push_back(part->second);
    return found;
}

/// Looks for earlier faces in the rings of faces around the face `unbroken` of the unfractured mesh, and
/// returns all that it finds in the first ring that has any. Needed where cracks have moved vertices: the
/// earlier faces that cover `unbroken` may then all have neighbours of it as parents.
std::vector<Index> Parts::nearest_parts(Index unbroken) const {
    const auto& faces = later.rest.unfractured_faces;
    std::set<Index> ring{unbroken};
    std::vector<Index> found;
    for (std::size_t before = 0; found.empty() && before < ring.size();) {
        before = ring.size();
        std::set<Index> corners;
        for (const Index face : ring) corners.insert(faces[face].begin(), faces[face].end());
        for (std::size_t f = 0; f < faces.size(); ++f)
            if (std::ranges::any_of(faces[f], [&](Index v) { return corners.contains(v); }))
                ring.insert(static_cast<Index>(f));
        found = parts_of(ring);
    }
    return found;
}

Index Parts::whole_of(std::size_t face) {
    const Index parent = later.rest.face_parent[face];
    Vector3d centre = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) centre += corner_place(face, k) / 3;
    Index whole = -1;
    double depth = -std::numeric_limits<double>::infinity();
    const auto look_at = [&](Index candidate) {
        const double inside = coordinates(candidate, centre).minCoeff();
        if (inside > depth) std::tie(whole, depth) = std::pair(candidate, inside);
    };
    std::ranges::for_each(parts_of({parent}), look_at);
    if (any_mixed()) {
        for (const Index v : later.rest.faces[face])
            if (v < static_cast<Index>(faces_around.size()))
                for (const Index around : faces_around[v]) look_at(around);
        if (whole < 0) std::ranges::for_each(nearest_parts(parent), look_at);
    }
    if (whole < 0)
        throw Error(fmt::format(
            "face {} at {:g} s is a part of face {} of the unbroken mesh, of which no part exists at {:g} s",
            face, later.time, parent, earlier.time));
    return whole;
}

Index Parts::same_vertex(std::size_t face, int corner, Index whole) const {
    const Index vertex = later.rest.faces[face][corner];
    if (!stays(vertex)) return -1;
    const auto& corners = earlier.rest.faces[whole];
    const auto found = std::ranges::find(corners, vertex);
    if (found != corners.end()) return earlier.faces[whole][found - corners.begin()];
    return of_vertex[vertex].size() == 1 ? of_vertex[vertex].front() : -1;
}

std::pair<Index, Vector3d> Parts::place(std::size_t face, int corner, Index whole) const {
    const Vector3d point = corner_place(face, corner);
    Index nearest = whole;
    Vector3d best = coordinates(whole, point);
    constexpr double inside = -1e-9;
    if (best.minCoeff() >= inside || !any_mixed()) return {nearest, best};
    for (const Index vertex : earlier.rest.faces[whole])
        for (const Index around : faces_around[vertex]) {
            const Vector3d place = coordinates(around, point);
            if (earlier.face_fragment[around] != earlier.face_fragment[whole] ||
                place.minCoeff() <= best.minCoeff())
                continue;
            std::tie(nearest, best) = std::pair(around, place);
        }
    return {nearest, best};
}

}  // namespace

Positions FrameParents::interpolated_from(const Positions& earlier) const {
    Positions values(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto& [a, b, c] = vertices[v];
        const auto& [at_a, at_b, at_c] = weights[v];
        // The value of a single vertex is copied: 0 times an infinite value would be NaN.
        values.col(static_cast<Eigen::Index>(v)) =
            at_a == 1 ? Vector3d(earlier.col(a))
                      : Vector3d(at_a * earlier.col(a) + at_b * earlier.col(b) + at_c * earlier.col(c));
    }
    return values;
}

FrameParents frame_parents(const Snapshot& earlier, const Snapshot& later) {
    if (earlier.faces.size() > later.faces.size() ||
        earlier.rest.unfractured_faces.size() != later.rest.unfractured_faces.size())
        throw Error(
            fmt::format("the frames at {:g} s and {:g} s have {} and {} faces: states between them cannot be "
                        "interpolated",
                        earlier.time, later.time, earlier.faces.size(), later.faces.size()));
    FrameParents frame_parents;
    const auto set = [&](Index vertex, Index one) {
        frame_parents.vertices[vertex] = {one, one, one};
        frame_parents.weights[vertex] = {1, 0, 0};
    };
    frame_parents.vertices.resize(later.position.cols());
    frame_parents.weights.resize(later.position.cols());
    const auto last = static_cast<Index>(earlier.position.cols() - 1);
    for (Index v = 0; v < static_cast<Index>(later.position.cols()); ++v) set(v, std::min(v, last));
    Parts parts(earlier, later);
    for (std::size_t f = 0; f < later.faces.size(); ++f) {
        const Index whole = parts.is_unchanged(f) ? static_cast<Index>(f) : parts.whole_of(f);
        frame_parents.faces.push_back(whole);
        for (int k = 0; k < 3; ++k) {
            const Index vertex = later.faces[f][k];
            const Index same = parts.is_unchanged(f) ? earlier.faces[f][k] : parts.same_vertex(f, k, whole);
            if (same >= 0) {
                set(vertex, same);
                continue;
            }
            const auto [face, place] = parts.place(f, k, whole);
            frame_parents.vertices[vertex] = earlier.faces[face];
            frame_parents.weights[vertex] = {place.x(), place.y(), place.z()};
        }
    }
    return frame_parents;
}

}  // namespace sherd
