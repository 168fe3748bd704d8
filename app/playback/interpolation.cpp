// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/interpolation.h"

#include <fmt/format.h>

#include <algorithm>

#include "meshops/error.h"

namespace sherd {
namespace {

/// The earlier frame's vertex that each of the later one was, which faces know: they keep their corners.
std::vector<Index> vertices_before(const Snapshot& earlier, const Snapshot& later) {
    std::vector<Index> before(later.position.cols());
    for (std::size_t v = 0; v < before.size(); ++v)
        before[v] = std::min(static_cast<Index>(v), static_cast<Index>(earlier.position.cols() - 1));
    for (std::size_t f = 0; f < later.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) before[later.faces[f][k]] = earlier.faces[f][k];
    return before;
}

/// Edges that the crack made on the way are its rim: they carry no hinge.
void say_of_edges(const Snapshot& earlier, double share, Snapshot& between) {
    for (std::size_t e = 0; e < earlier.edges.size() && e < between.edges.size(); ++e) {
        const bool unbroken =
            earlier.edge_state[e] == EdgeState::interior && between.edge_state[e] == EdgeState::interior;
        between.edge_strain[e] =
            unbroken ? earlier.edge_strain[e] + share * (between.edge_strain[e] - earlier.edge_strain[e])
                     : earlier.edge_strain[e];
        between.edge_state[e] = earlier.edge_state[e];
    }
}

}  // namespace

Snapshot interpolated(const Snapshot& earlier, const Snapshot& later, double share) {
    if (earlier.faces.size() != later.faces.size())
        throw Error(
            fmt::format("the frames at {:g} s and {:g} s have {} and {} faces: there is nothing between",
                        earlier.time, later.time, earlier.faces.size(), later.faces.size()));
    Snapshot between = later;
    between.step = earlier.step;
    between.time = earlier.time + share * (later.time - earlier.time);
    const std::vector<Index> before = vertices_before(earlier, later);
    const auto on_the_way = [&](const auto& from, const auto& to) {
        return (from + share * (to - from)).eval();
    };
    between.position = on_the_way(earlier.position(Eigen::all, before), later.position);
    between.velocity = on_the_way(earlier.velocity(Eigen::all, before), later.velocity);
    between.face_fragment = earlier.face_fragment;
    say_of_edges(earlier, share, between);
    return between;
}

Eigen::Isometry3d interpolated(const Eigen::Isometry3d& earlier, const Eigen::Isometry3d& later, double share,
                               const Vector3d& pivot) {
    if (!earlier.matrix().allFinite() || !later.matrix().allFinite()) return earlier;
    const Eigen::Quaterniond from(earlier.rotation()), to(later.rotation());
    const Vector3d start = earlier * pivot, place = start + share * (later * pivot - start);
    return Eigen::Translation3d(place) * from.slerp(share, to) * Eigen::Translation3d(-pivot);
}

}  // namespace sherd
