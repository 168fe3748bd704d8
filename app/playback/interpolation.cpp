// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/interpolation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "app/playback/frame_parents.h"
#include "core/elements/mid_edge.h"

namespace sherd {
namespace {

/// Finds the edge of the earlier frame on which an edge that was inserted later lies.
class EdgeSearch {
  public:
    EdgeSearch(const Snapshot& earlier, const FrameParents& frame_parents) : frame_parents(frame_parents) {
        for (std::size_t e = 0; e < earlier.edges.size(); ++e) {
            const auto [low, high] = std::minmax(earlier.edges[e][0], earlier.edges[e][1]);
            numbers[{low, high}] = e;
        }
    }

    /// Returns the number of the earlier edge; none if `edge` lies inside an earlier face.
    std::optional<std::size_t> below(const std::array<Index, 2>& edge) const {
        constexpr double round_off = 1e-9;
        std::set<Index> ends;
        for (const Index v : edge)
            for (int k = 0; k < 3; ++k)
                if (std::abs(frame_parents.weights[v][k]) > round_off)
                    ends.insert(frame_parents.vertices[v][k]);
        const auto found = ends.size() == 2 ? numbers.find({*ends.begin(), *ends.rbegin()}) : numbers.end();
        return found == numbers.end() ? std::nullopt : std::optional(found->second);
    }

  private:
    const FrameParents& frame_parents;
    std::map<std::array<Index, 2>, std::size_t> numbers;
};

/// Sets the strains and states of the edges that the earlier frame has. Edges that a crack has made since
/// then form its rim and have no hinge: their strain and state stay.
void report_edges(const Snapshot& earlier, double share, Snapshot& between) {
    for (std::size_t e = 0; e < earlier.edges.size() && e < between.edges.size(); ++e) {
        const bool unbroken =
            earlier.edge_state[e] == EdgeState::interior && between.edge_state[e] == EdgeState::interior;
        between.edge_strain[e] =
            unbroken ? earlier.edge_strain[e] + share * (between.edge_strain[e] - earlier.edge_strain[e])
                     : earlier.edge_strain[e];
        between.edge_state[e] = earlier.edge_state[e];
    }
    between.edge_cohesive_share = earlier.edge_cohesive_share;
    if (!between.edge_cohesive_share.empty()) between.edge_cohesive_share.resize(between.edges.size());
}

/// Sets the strains of edges that were inserted since the earlier frame. An inserted edge with a hinge is a
/// part of an earlier edge, or lies inside an earlier face, which does not bend: its strain there was 0.
void report_inserted_edges(const Snapshot& earlier, const FrameParents& frame_parents, double share,
                           Snapshot& between) {
    std::optional<EdgeSearch> search;
    for (std::size_t e = earlier.edges.size(); e < between.edges.size(); ++e) {
        if (between.edge_state[e] != EdgeState::interior) continue;
        if (!search) search.emplace(earlier, frame_parents);
        const std::optional<std::size_t> below = search->below(between.edges[e]);
        const double before = below ? earlier.edge_strain[*below] : 0;
        between.edge_strain[e] = before + share * (between.edge_strain[e] - before);
    }
}

/// Returns the angle, rad, from the first axis (frame_axes()) of the later face `face` at rest to the first
/// axis of the earlier face `before`, which `face` was or was a part of.
double turn_of_frame(const RestMesh& earlier, Index before, const RestMesh& later, std::size_t face) {
    if (earlier.faces[before] == later.faces[face]) return 0;
    const auto axes = frame_axes(columns(later.position, later.faces[face]));
    const Vector3d old = frame_axes(columns(earlier.position, earlier.faces[before])).col(0);
    return std::atan2(axes.col(1).dot(old), axes.col(0).dot(old));
}

/// Interpolates the fields of faces that both frames have. Components of tensors refer to the axes of the
/// later faces.
void report_fields(const Snapshot& earlier, const FrameParents& frame_parents, double share,
                   Snapshot& between) {
    std::vector<const Eigen::Matrix3Xd*> before;
    visit_fields(earlier.fields, [&](const char*, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        before.push_back(&values);
    });
    auto next = before.begin();
    visit_fields(between.fields, [&](const char*, Eigen::Matrix3Xd& values, const FieldMeaning& meaning) {
        const Eigen::Matrix3Xd& from = **next++;
        const double count = meaning.twice ? 2 : 1;
        for (Eigen::Index f = 0; f < values.cols() && from.cols() > 0; ++f) {
            const Index whole = frame_parents.faces[f];
            Vector3d start = from.col(whole);
            const double turn = turn_of_frame(earlier.rest, whole, between.rest, f);
            if (turn != 0) {
                start = turned_tensor({start[0], start[1], start[2] / count}, turn);
                start[2] *= count;
            }
            values.col(f) = (start + share * (values.col(f) - start)).eval();
        }
    });
}

}  // namespace

Snapshot interpolated(const Snapshot& earlier, const Snapshot& later, double share) {
    const FrameParents before = frame_parents(earlier, later);
    Snapshot between = later;
    between.step = earlier.step;
    between.time = earlier.time + share * (later.time - earlier.time);
    const auto on_the_way = [&](const auto& from, const auto& to) {
        return (from + share * (to - from)).eval();
    };
    between.position = on_the_way(before.interpolated_from(earlier.position), later.position);
    between.velocity = on_the_way(before.interpolated_from(earlier.velocity), later.velocity);
    for (std::size_t f = 0; f < between.faces.size(); ++f)
        between.face_fragment[f] = earlier.face_fragment[before.faces[f]];
    report_edges(earlier, share, between);
    report_inserted_edges(earlier, before, share, between);
    report_fields(earlier, before, share, between);
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
