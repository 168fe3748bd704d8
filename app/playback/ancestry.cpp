// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/ancestry.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "meshops/error.h"

namespace sherd {
namespace {

/// Finds the faces of the earlier frame that those of the later one are parts of.
class Parts {
  public:
    Parts(const Snapshot& earlier, const Snapshot& later) : earlier(earlier), later(later) {}

    bool is_unchanged(std::size_t face) const {
        return face < earlier.faces.size() && earlier.rest.faces[face] == later.rest.faces[face];
    }
    /// Throws Error when there is none.
    Index whole_of(std::size_t face);
    /// Barycentric coordinates in an earlier face of a corner of a later one.
    Vector3d place(std::size_t face, int corner, Index whole) const {
        return places(whole).inverse() * place_in_parent(later.rest, face, corner);
    }

  private:
    using Part =
        std::pair<Index, Index>;  ///< a face of the unbroken mesh, and one of the earlier frame in it

    /// Of the three corners of an earlier face, in the face of the unbroken mesh.
    Matrix3d places(Index face) const {
        Matrix3d columns;
        for (int k = 0; k < 3; ++k) columns.col(k) = place_in_parent(earlier.rest, face, k);
        return columns;
    }

    const Snapshot &earlier, &later;
    std::vector<Part> parts;  ///< ascending; made when it is needed, as most runs split no face
};

Index Parts::whole_of(std::size_t face) {
    if (parts.empty()) {
        for (std::size_t f = 0; f < earlier.faces.size(); ++f)
            parts.emplace_back(earlier.rest.face_parent[f], static_cast<Index>(f));
        std::ranges::sort(parts);
    }
    const Index parent = later.rest.face_parent[face];
    Vector3d centre = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) centre += place_in_parent(later.rest, face, k) / 3;
    Index whole = -1;
    double depth = -std::numeric_limits<double>::infinity();
    for (auto part = std::ranges::lower_bound(parts, Part(parent, 0));
         part != parts.end() && part->first == parent; ++part) {
        const Matrix3d corners = places(part->second);
        if (corners.determinant() == 0) continue;
        const double inside = (corners.inverse() * centre).minCoeff();
        if (inside > depth) std::tie(whole, depth) = std::pair(part->second, inside);
    }
    if (whole < 0)
        throw Error(fmt::format(
            "face {} at {:g} s is a part of face {} of the unbroken mesh, which has none at {:g} s", face,
            later.time, parent, earlier.time));
    return whole;
}

/// The corner of a face with a given vertex at rest, -1: none.
int corner_with(const RestMesh& rest, Index face, Index vertex) {
    const auto& corners = rest.faces[face];
    const auto found = std::ranges::find(corners, vertex);
    return found == corners.end() ? -1 : static_cast<int>(found - corners.begin());
}

}  // namespace

Positions Ancestry::carried(const Positions& earlier) const {
    Positions values(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto& [a, b, c] = vertices[v];
        const auto& [at_a, at_b, at_c] = weights[v];
        // One vertex alone is as it is, whatever it holds.
        values.col(static_cast<Eigen::Index>(v)) =
            at_a == 1 ? Vector3d(earlier.col(a))
                      : Vector3d(at_a * earlier.col(a) + at_b * earlier.col(b) + at_c * earlier.col(c));
    }
    return values;
}

Ancestry ancestry(const Snapshot& earlier, const Snapshot& later) {
    if (earlier.faces.size() > later.faces.size() ||
        earlier.rest.unbroken_faces.size() != later.rest.unbroken_faces.size())
        throw Error(
            fmt::format("the frames at {:g} s and {:g} s have {} and {} faces: there is nothing between",
                        earlier.time, later.time, earlier.faces.size(), later.faces.size()));
    Ancestry ancestry;
    const auto set = [&](Index vertex, Index one) {
        ancestry.vertices[vertex] = {one, one, one};
        ancestry.weights[vertex] = {1, 0, 0};
    };
    ancestry.vertices.resize(later.position.cols());
    ancestry.weights.resize(later.position.cols());
    const auto last = static_cast<Index>(earlier.position.cols() - 1);
    for (Index v = 0; v < static_cast<Index>(later.position.cols()); ++v) set(v, std::min(v, last));
    Parts parts(earlier, later);
    for (std::size_t f = 0; f < later.faces.size(); ++f) {
        const Index whole = parts.is_unchanged(f) ? static_cast<Index>(f) : parts.whole_of(f);
        ancestry.faces.push_back(whole);
        for (int k = 0; k < 3; ++k) {
            const Index vertex = later.faces[f][k];
            const int same =
                parts.is_unchanged(f) ? k : corner_with(earlier.rest, whole, later.rest.faces[f][k]);
            if (same >= 0) {
                set(vertex, earlier.faces[whole][same]);
                continue;
            }
            const Vector3d place = parts.place(f, k, whole);
            ancestry.vertices[vertex] = earlier.faces[whole];
            ancestry.weights[vertex] = {place.x(), place.y(), place.z()};
        }
    }
    return ancestry;
}

}  // namespace sherd
