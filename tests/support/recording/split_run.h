// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>

#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {

/// Synthetic run in which a crack splits faces. Three triangles lie side by side, with numbers of vertices,
///
///     3 --- 2 .
///     | B / |  .      A = 0 1 2, 1 mm thick,
///     |  m  | C  .    B = 0 2 3, 1 mm,
///     | / A |     .   C = 1 4 2, 2 mm.
///     0 --- 1 ---- 4
///
/// Frame 0 is the rest shape. In frame 1 the crack has split A and B at the new vertex m, at a quarter of the
/// edge from 0 to 2; the crack is still closed. In frame 2 the crack has opened from 1 over m to 3, so that
/// the piece with vertex 0 moves away from the piece with vertices 2 and 4, and a vertex is inserted inside
/// C. In frame 3 the parts of A and B at vertex 2 are split again, between m and 2. Before frame 4 nothing is
/// inserted. Each piece moves rigidly.
namespace split {

inline constexpr Index a = 0, b = 1, c = 2;                   // numbers of faces
inline constexpr Index m = 5, right_m = 7, in_c = 9, n = 10;  // numbers of vertices
inline constexpr double density = 1000;

struct VertexParents {
    std::array<Index, 3> parents;
    std::array<double, 3> weights;
};

/// Parents of all vertices of the run. Vertices 6, 7 and 8 are the copies of 1, m and 3.
inline const std::vector<VertexParents>& parents_of_vertices() {
    static const std::vector<VertexParents> all{
        {{0, 0, 0}, {1, 0, 0}},         {{1, 1, 1}, {1, 0, 0}},        {{2, 2, 2}, {1, 0, 0}},
        {{3, 3, 3}, {1, 0, 0}},         {{4, 4, 4}, {1, 0, 0}},        {{0, 2, 0}, {0.75, 0.25, 0}},
        {{1, 1, 1}, {1, 0, 0}},         {{0, 2, 0}, {0.75, 0.25, 0}},  {{3, 3, 3}, {1, 0, 0}},
        {{1, 4, 2}, {0.5, 0.25, 0.25}}, {{0, 2, 0}, {0.375, 0.625, 0}}};
    return all;
}

inline RecordingHeader header() {
    RecordingHeader header{.scene_file = "split.toml",
                           .scene_text = "duration = 0.4\n",
                           .seed = 3,
                           .sheet_names = {"plate"},
                           .rest_position = Positions::Zero(3, 5),
                           .rest_faces = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}},
                           .rest_area = {0.5, 0.5, 0.5},
                           .rest_thickness = {1e-3, 1e-3, 2e-3},
                           .supports = synthetic::supports(),
                           .gauges = synthetic::gauges()};
    header.rest_position.topRows<2>() << 0, 1, 1, 0, 2,  //
        0, 0, 1, 1, 0;
    return header;
}

/// Interpolates the unfractured mesh's values (in columns) between the parents of a vertex.
inline Vector3d between_parents(const Positions& values, Index vertex) {
    const auto& [parents, weights] = parents_of_vertices()[vertex];
    Vector3d sum = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) sum += weights[k] * values.col(parents[k]);
    return sum;
}

/// Faces of a frame, their parents in the unfractured mesh, and the frame's edges.
struct Topology {
    std::vector<std::array<Index, 3>> faces;
    std::vector<Index> parent;
    std::vector<std::array<Index, 2>> edges;
};

inline Topology topology(std::size_t frame) {
    if (frame == 0)
        return {{{0, 1, 2}, {0, 2, 3}, {1, 4, 2}},
                {a, b, c},
                {{0, 1}, {1, 2}, {0, 2}, {2, 3}, {0, 3}, {1, 4}, {4, 2}}};
    if (frame == 1)
        return {{{0, 1, 5}, {0, 5, 3}, {1, 4, 2}, {5, 1, 2}, {5, 2, 3}},
                {a, b, c, a, b},
                {{0, 1}, {1, 2}, {0, 5}, {2, 3}, {0, 3}, {1, 4}, {4, 2}, {5, 2}, {1, 5}, {5, 3}}};
    Topology opened{{{0, 1, 5}, {0, 5, 3}, {6, 4, 9}, {7, 6, 2}, {7, 2, 8}, {4, 2, 9}, {2, 6, 9}},
                    {a, b, c, a, b, c, c},
                    {{0, 1},
                     {6, 2},
                     {0, 5},
                     {2, 8},
                     {0, 3},
                     {6, 4},
                     {4, 2},
                     {7, 2},
                     {1, 5},
                     {5, 3},
                     {6, 7},
                     {7, 8},
                     {6, 9},
                     {4, 9},
                     {2, 9}}};
    if (frame == 2) return opened;
    opened.faces[3] = {7, 6, 10};
    opened.faces[4] = {7, 10, 8};
    opened.faces.insert(opened.faces.end(), {{10, 6, 2}, {10, 2, 8}});
    opened.parent.insert(opened.parent.end(), {a, b});
    opened.edges[7] = {7, 10};
    opened.edges.insert(opened.edges.end(), {{10, 2}, {6, 10}, {10, 8}});
    return opened;
}

inline std::vector<Index> originals(std::size_t vertices) {
    std::vector<Index> original{0, 1, 2, 3, 4, 5, 1, 5, 3, 9, 10};
    original.resize(vertices);
    return original;
}

/// Motion of a piece in a frame. piece: 0 has vertex 0, 1 is the other piece.
inline Eigen::Isometry3d motion(std::size_t frame, Index piece) {
    const auto k = static_cast<double>(frame);
    const double side = frame < 2 ? 0 : piece == 0 ? -1 : 1;
    return Eigen::Translation3d(0.1 * side * k, 0.05 * side, 0.1 * k) *
           Eigen::AngleAxisd(0.2 * side * k, Vector3d::UnitZ());
}

inline void add_masses(Snapshot& frame) {
    frame.mass = VectorXd::Zero(frame.position.cols());
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f])
            frame.mass[v] += density * frame.rest.thickness[f] * frame.rest.area[f] / 3;
}

inline void add_edges_of(Snapshot& frame, const Topology& topology) {
    std::map<std::array<Index, 2>, int> count;
    for (const auto& f : frame.faces)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(f[k], f[(k + 1) % 3]);
            ++count[{low, high}];
        }
    frame.edges = topology.edges;
    for (std::size_t e = 0; e < frame.edges.size(); ++e) {
        const auto [low, high] = std::minmax(frame.edges[e][0], frame.edges[e][1]);
        const bool shared = count.at({low, high}) == 2;
        frame.edge_state.push_back(shared ? EdgeState::interior : EdgeState::boundary);
        frame.edge_strain.push_back(shared ? 8 + static_cast<double>(e) : 0);
    }
}

inline RestMesh rest(const RecordingHeader& header, const Topology& topology, std::size_t vertices) {
    RestMesh rest = recording_format::unfractured_mesh(header);
    rest.position.resize(3, static_cast<Eigen::Index>(vertices));
    rest.vertex_parents.clear();
    rest.vertex_weights.clear();
    rest.faces.clear();
    rest.area.clear();
    rest.thickness.clear();
    rest.face_parent = topology.parent;
    for (std::size_t v = 0; v < vertices; ++v) {
        rest.position.col(static_cast<Eigen::Index>(v)) =
            between_parents(header.rest_position, static_cast<Index>(v));
        rest.vertex_parents.push_back(parents_of_vertices()[v].parents);
        rest.vertex_weights.push_back(parents_of_vertices()[v].weights);
    }
    const std::vector<Index> original = originals(vertices);
    for (std::size_t f = 0; f < topology.faces.size(); ++f) {
        const auto& [p, q, r] = topology.faces[f];
        rest.faces.push_back({original[p], original[q], original[r]});
        const Vector3d side = rest.position.col(q) - rest.position.col(p),
                       other = rest.position.col(r) - rest.position.col(p);
        rest.area.push_back(side.cross(other).norm() / 2);
        rest.thickness.push_back(header.rest_thickness[topology.parent[f]]);
    }
    return rest;
}

inline Snapshot snapshot(const RecordingHeader& header, std::size_t number) {
    const std::size_t vertices = std::array<std::size_t, 5>{5, 6, 10, 11, 11}[number];
    const Topology mesh = topology(std::min<std::size_t>(number, 3));
    Snapshot frame;
    frame.step = 10 * static_cast<std::int64_t>(number);
    frame.time = 0.1 * static_cast<double>(number);
    frame.original = originals(vertices);
    frame.faces = mesh.faces;
    frame.face_sheet.assign(mesh.faces.size(), 0);
    frame.rest = rest(header, mesh, vertices);
    frame.position.resize(3, static_cast<Eigen::Index>(vertices));
    frame.velocity = Positions::Constant(3, static_cast<Eigen::Index>(vertices), 0.5 * frame.time);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Index piece = number >= 2 && f > 1 ? 1 : 0;
        frame.face_fragment.push_back(piece);
        for (const Index v : mesh.faces[f])
            frame.position.col(v) = motion(number, piece) * Vector3d(frame.rest.position.col(v));
    }
    add_masses(frame);
    add_edges_of(frame, mesh);
    return frame;
}

inline std::vector<CrackEvents> events() {
    std::vector<CrackEvents> events(5);
    events[1].vertex_insertions = {{0.1, 10, m, {0, 2, 0}, {0.75, 0.25, 0}}};
    events[1].face_insertions = {{0.1, 10, 3, a}, {0.1, 10, 4, b}};
    events[2].failures = {{0.2, 20, 0, 8, {1, 5}, 1, 9, 1e7, 2}, {0.2, 20, 0, 9, {5, 3}, 1, 9, 1e7, 3}};
    events[2].openings = {{0.2, 20, 8, 10}, {0.2, 20, 9, 11}};
    events[2].splits = {{0.2, 20, 1, 6}, {0.2, 20, 5, 7}, {0.2, 20, 3, 8}};
    events[2].fragment_splits = {{0.2, 20, 1, 0}};
    events[2].vertex_insertions = {{0.2, 20, in_c, {6, 4, 2}, {0.5, 0.25, 0.25}}};
    events[2].face_insertions = {{0.2, 20, 5, c}, {0.2, 20, 6, c}};
    events[3].vertex_insertions = {{0.3, 30, n, {7, 2, 7}, {0.5, 0.5, 0}}};
    events[3].face_insertions = {{0.3, 30, 7, 3}, {0.3, 30, 8, 4}};
    return events;
}

}  // namespace split

inline SyntheticRun split_run() {
    SyntheticRun run;
    run.header = split::header();
    run.events = split::events();
    for (std::size_t k = 0; k < 5; ++k) {
        run.frames.push_back(split::snapshot(run.header, k));
        std::vector<StepReport> steps;
        for (Index i = 10 * static_cast<Index>(k - 1) + 1; k > 0 && i <= 10 * static_cast<Index>(k); ++i) {
            steps.push_back(synthetic::step(i));
            steps.back().fragments = k < 2 ? 1 : 2;
        }
        run.steps.push_back(steps);
    }
    return run;
}

}  // namespace sherd::test
