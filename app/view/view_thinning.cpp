// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view_thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sherd {
namespace {

using Cube = std::array<std::int64_t, 4>;  ///< the sheet, and the place in the grid

/// Edges that became one.
struct MergedEdge {
    EdgeState state;
    double strain = 0;  ///< sum of the hinges' magnitudes
    int hinges = 0;
};

/// The more telling of two.
EdgeState merged(EdgeState a, EdgeState b) {
    for (const EdgeState state : {EdgeState::fractured_interior, EdgeState::interior})
        if (a == state || b == state) return state;
    return a;
}

void merge_edges(const Snapshot& frame, std::span<const Index> merged_vertex, Snapshot& coarse) {
    std::map<std::array<Index, 2>, MergedEdge> edges;
    for (std::size_t e = 0; e < frame.edges.size(); ++e) {
        const auto [a, b] = std::minmax(merged_vertex[frame.edges[e][0]], merged_vertex[frame.edges[e][1]]);
        if (a < 0 || a == b) continue;
        const EdgeState state = frame.edge_state[e];
        MergedEdge& edge = edges.try_emplace({a, b}, MergedEdge{state}).first->second;
        edge.state = merged(edge.state, state);
        if (state != EdgeState::interior) continue;
        edge.strain += std::abs(frame.edge_strain[e]);
        ++edge.hinges;
    }
    for (const auto& [ends, edge] : edges) {
        coarse.edges.push_back(ends);
        coarse.edge_state.push_back(edge.state);
        coarse.edge_strain.push_back(edge.hinges > 0 ? edge.strain / edge.hinges : 0);
    }
}

}  // namespace

MeshThinning::MeshThinning(const RecordingHeader& header, std::span<const Index> face_sheet, double cube)
    : length(cube), cubes(header.rest_position.cols(), -1) {
    std::map<Cube, Index> numbers;
    for (std::size_t f = 0; f < header.rest_faces.size(); ++f)
        for (const Index v : header.rest_faces[f]) {
            if (cubes[v] >= 0) continue;
            Cube at{face_sheet[f]};
            for (int k = 0; k < 3; ++k)
                at[k + 1] = static_cast<std::int64_t>(std::floor(header.rest_position(k, v) / cube));
            cubes[v] = numbers.try_emplace(at, static_cast<Index>(numbers.size())).first->second;
        }
    for (std::size_t f = 0; f < header.rest_faces.size(); ++f) {
        const auto& [a, b, c] = header.rest_faces[f];
        if (cubes[a] != cubes[b] && cubes[b] != cubes[c] && cubes[c] != cubes[a]) kept.push_back(f);
    }
    // Only those that a face needs have a number.
    std::vector<Index> number(numbers.size(), -1);
    for (const std::size_t f : kept)
        for (const Index v : header.rest_faces[f])
            if (Index& next = number[cubes[v]]; next < 0) next = count++;
    for (Index& cube_number : cubes)
        if (cube_number >= 0) cube_number = number[cube_number];
}

RecordingHeader MeshThinning::thinned(const RecordingHeader& header) const {
    RecordingHeader coarse;
    for (const std::size_t f : kept) {
        const auto& [a, b, c] = header.rest_faces[f];
        coarse.rest_faces.push_back({cubes[a], cubes[b], cubes[c]});
        if (!header.rest_thickness.empty()) coarse.rest_thickness.push_back(header.rest_thickness[f]);
    }
    return coarse;
}

Snapshot MeshThinning::thinned(const Snapshot& frame) const {
    Snapshot coarse;
    coarse.step = frame.step;
    coarse.time = frame.time;
    // Of cube and fragment. One of each cube has the cube's number, so that few numbers change with the
    // fragments.
    std::map<std::pair<Index, Index>, Index> numbers;
    std::vector<char> given(count, 0);
    Index more = count;
    for (const std::size_t f : kept) {
        const Index fragment = frame.face_fragment[f];
        std::array<Index, 3> face;
        for (int k = 0; k < 3; ++k) {
            const std::pair key(cubes[frame.original[frame.faces[f][k]]], fragment);
            const auto [place, is_new] = numbers.try_emplace(key, key.first);
            if (is_new && std::exchange(given[key.first], 1)) place->second = more++;
            face[k] = place->second;
        }
        coarse.faces.push_back(face);
        coarse.face_fragment.push_back(fragment);
    }
    // All faces at a vertex are of one fragment.
    std::vector<Index> merged_vertex(frame.position.cols(), -1);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f])
            if (const auto found = numbers.find({cubes[frame.original[v]], frame.face_fragment[f]});
                found != numbers.end())
                merged_vertex[v] = found->second;
    coarse.position = Positions::Zero(3, more);
    VectorXd members = VectorXd::Zero(more);
    for (Eigen::Index v = 0; v < frame.position.cols(); ++v)
        if (const Index merged = merged_vertex[v]; merged >= 0) {
            coarse.position.col(merged) += frame.position.col(v);
            ++members[merged];
        }
    coarse.position.array().rowwise() /= members.transpose().array();
    merge_edges(frame, merged_vertex, coarse);
    return coarse;
}

}  // namespace sherd
