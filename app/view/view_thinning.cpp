// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view_thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace sherd {
namespace {

using Cube = std::array<std::int64_t, 4>;  ///< number of the sheet, and the three indices of the cube in the
                                           ///< grid

/// An edge into which edges of the recording are merged.
struct MergedEdge {
    EdgeState state;
    double strain = 0;  ///< 1/m, sum of |strain| of the merged hinges
    int hinges = 0;
};

/// Returns the state of an edge into which two edges are merged: fractured if one of them is, else interior
/// if one of them is.
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

/// Returns, for each face of the unfractured mesh, the number of the part of it whose corners lie in three
/// cubes, or the number of the face itself if there is no such part. cube: [R] cube of each vertex at rest.
std::vector<std::size_t> faces_standing_for_their_parents(const RestMesh& rest, std::span<const Index> cube) {
    std::vector<std::size_t> standing(rest.unfractured_faces.size());
    std::iota(standing.begin(), standing.end(), std::size_t{0});
    for (std::size_t f = rest.faces.size(); f-- > 0;) {
        const auto& [a, b, c] = rest.faces[f];
        if (cube[a] != cube[b] && cube[b] != cube[c] && cube[c] != cube[a]) standing[rest.face_parent[f]] = f;
    }
    return standing;
}

/// Returns the mean position of the vertices that are merged into each of `count` vertices, [3, count] m.
/// merged_vertex: [V] vertex into which each is merged, -1: none.
Positions merged_positions(const Snapshot& frame, std::span<const Index> merged_vertex, Index count) {
    Positions position = Positions::Zero(3, count);
    VectorXd members = VectorXd::Zero(count);
    for (Eigen::Index v = 0; v < frame.position.cols(); ++v)
        if (const Index merged = merged_vertex[v]; merged >= 0) {
            position.col(merged) += frame.position.col(v);
            ++members[merged];
        }
    position.array().rowwise() /= members.transpose().array();
    return position;
}

/// Returns the fields of the kept faces: fields of the faces that represent them (`standing`), in the axes of
/// these faces.
FaceFields fields_of(const Snapshot& frame, std::span<const std::size_t> kept,
                     std::span<const std::size_t> standing) {
    FaceFields fields = frame.fields;
    visit_fields(fields, [&](const char*, Eigen::Matrix3Xd& values, const FieldMeaning&) {
        if (values.cols() == 0) return;
        const Eigen::Matrix3Xd all = values;
        values.resize(3, static_cast<Eigen::Index>(kept.size()));
        for (std::size_t i = 0; i < kept.size(); ++i)
            values.col(static_cast<Eigen::Index>(i)) = all.col(static_cast<Eigen::Index>(standing[kept[i]]));
    });
    return fields;
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
    // Only cubes with corners of kept faces get a number.
    std::vector<Index> number(numbers.size(), -1);
    for (const std::size_t f : kept)
        for (const Index v : header.rest_faces[f])
            if (Index& next = number[cubes[v]]; next < 0) next = count++;
    for (Index& cube_number : cubes)
        if (cube_number >= 0) cube_number = number[cube_number];
}

/// Returns the cube of each vertex at rest: the cube of its nearest parent in the unfractured mesh.
std::vector<Index> MeshThinning::cubes_of(const RestMesh& rest) const {
    std::vector<Index> result;
    for (std::size_t v = 0; v < rest.vertex_parents.size(); ++v) {
        const auto nearest =
            std::ranges::max_element(rest.vertex_weights[v]) - rest.vertex_weights[v].begin();
        result.push_back(cubes[rest.vertex_parents[v][nearest]]);
    }
    return result;
}

Snapshot MeshThinning::thinned(const Snapshot& frame) const {
    Snapshot coarse;
    coarse.step = frame.step;
    coarse.time = frame.time;
    const std::vector<Index> cube = cubes_of(frame.rest);
    const std::vector<std::size_t> standing = faces_standing_for_their_parents(frame.rest, cube);
    // Number of each merged vertex by its cube and fragment. The first vertex of a cube has the cube's
    // number, so that few numbers change when fragments separate.
    std::map<std::pair<Index, Index>, Index> numbers;
    std::vector<char> given(count, 0);
    Index more = count;
    std::vector<std::array<Index, 3>> rest_faces;
    std::vector<double> thickness;
    for (const std::size_t f : kept) {
        const std::size_t part = standing[f];
        const Index fragment = frame.face_fragment[part];
        std::array<Index, 3> face, rest_face;
        for (int k = 0; k < 3; ++k) {
            rest_face[k] = cubes[frame.rest.unfractured_faces[f][k]];
            const auto [place, is_new] = numbers.try_emplace({rest_face[k], fragment}, rest_face[k]);
            if (is_new && std::exchange(given[rest_face[k]], 1)) place->second = more++;
            face[k] = place->second;
        }
        coarse.faces.push_back(face);
        coarse.face_fragment.push_back(fragment);
        rest_faces.push_back(rest_face);
        if (!frame.rest.thickness.empty()) thickness.push_back(frame.rest.thickness[part]);
    }
    coarse.rest =
        unfractured_mesh(Positions::Zero(3, count), std::move(rest_faces), {}, std::move(thickness));
    // All faces at a vertex belong to the same fragment.
    std::vector<Index> merged_vertex(frame.position.cols(), -1);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f])
            if (const auto found = numbers.find({cube[frame.original[v]], frame.face_fragment[f]});
                found != numbers.end())
                merged_vertex[v] = found->second;
    coarse.position = merged_positions(frame, merged_vertex, more);
    coarse.fields = fields_of(frame, kept, standing);
    merge_edges(frame, merged_vertex, coarse);
    return coarse;
}

}  // namespace sherd
