// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/contact/geometry/distance.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd::test {

/// Square plates of side 0.1 m, turned against each other, of `count` x `count` squares of two triangles;
/// plate k lies at height k `spacing`. Each is a sheet of its own.
inline Shell stacked_plates(int plates, int count, double spacing, const Material& material) {
    const int side = count + 1;
    Positions rest(3, plates * side * side);
    std::vector<std::array<Index, 3>> triangles;
    Random random(4);
    for (int plate = 0; plate < plates; ++plate) {
        const Eigen::AngleAxisd turn(0.7 * plate, Vector3d::UnitZ());
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const Index v = (plate * side + j) * side + i;
                const bool inside = i > 0 && j > 0 && i < count && j < count;
                const double shake = inside ? 0.2 : 0;
                const Vector3d at(i - 0.5 * count + shake * random.uniform(-1, 1),
                                  j - 0.5 * count + shake * random.uniform(-1, 1), 0);
                rest.col(v) = turn * (0.1 / count * at) + Vector3d(0, 0, plate * spacing);
                if (i == count || j == count) continue;
                triangles.push_back({v, v + 1, v + side + 1});
                triangles.push_back({v, v + side + 1, v + side});
            }
    }
    Shell shell = small_sheet(rest, triangles, material);
    for (Index v = 0; v < static_cast<Index>(rest.cols()); ++v) shell.vertex_sheet[v] = v / (side * side);
    return shell;
}

/// Smallest distance between elements of different sheets, m, by comparing all of them.
inline double smallest_distance(const Shell& shell, const Positions& x) {
    double smallest = std::numeric_limits<double>::infinity();
    const auto look = [&](PairKind kind, const std::array<Index, 4>& vertices, Index a, Index b) {
        if (shell.vertex_sheet[a] == shell.vertex_sheet[b]) return;
        PairPositions local;
        for (int i = 0; i < 4; ++i) local.col(i) = x.col(vertices[i]);
        smallest = std::min(smallest, std::sqrt(squared_distance(closest_points(kind, local), local)));
    };
    for (const TriangleStencil& s : shell.triangles) {
        const auto [a, b, c] = s.vertices;
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            look(PairKind::vertex_triangle, {v, a, b, c}, v, a);
        for (const TriangleStencil& t : shell.triangles)
            for (int i = 0; i < 9; ++i) {
                const Index d = t.vertices[i / 3], e = t.vertices[(i / 3 + 1) % 3];
                look(PairKind::edge_edge, {s.vertices[i % 3], s.vertices[(i + 1) % 3], d, e}, a, d);
            }
    }
    return smallest;
}

/// Number of intersecting pairs of an edge and a triangle without a common vertex, by comparing all of them.
inline int intersections(const Shell& shell, const Positions& x) {
    const auto volume = [&](Index a, Index b, Index c, Index d) {
        return (x.col(b) - x.col(a)).cross(x.col(c) - x.col(a)).dot(x.col(d) - x.col(a));
    };
    int count = 0;
    for (const TriangleStencil& s : shell.triangles)
        for (const TriangleStencil& t : shell.triangles)
            for (int i = 0; i < 3; ++i) {
                const Index p = s.vertices[i], q = s.vertices[(i + 1) % 3];
                const auto [a, b, c] = t.vertices;
                if (p == a || p == b || p == c || q == a || q == b || q == c) continue;
                const bool both_sides = volume(a, b, c, p) * volume(a, b, c, q) < 0;
                const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
                count += both_sides && ((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0));
            }
    return count;
}

}  // namespace sherd::test
