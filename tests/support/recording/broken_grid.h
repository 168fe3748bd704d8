// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd::test {

/// Frame of one sheet without a crack, 1 mm thick, 1 kg/m^2.
inline Snapshot whole_sheet(const Positions& position, const std::vector<std::array<Index, 3>>& faces) {
    Snapshot frame;
    std::vector<double> area;
    frame.mass = VectorXd::Zero(position.cols());
    for (const auto& [a, b, c] : faces) {
        const Vector3d ab = position.col(b) - position.col(a), ac = position.col(c) - position.col(a);
        area.push_back(ab.cross(ac).norm() / 2);
        for (const Index corner : {a, b, c}) frame.mass[corner] += area.back() / 3;
    }
    frame.rest = unfractured_mesh(position, faces, area, std::vector<double>(faces.size(), 1e-3));
    frame.position = position;
    frame.velocity = Positions::Zero(3, position.cols());
    for (Index v = 0; v < position.cols(); ++v) frame.original.push_back(v);
    frame.faces = faces;
    frame.face_fragment.assign(faces.size(), 0);
    frame.face_sheet.assign(faces.size(), 0);
    return frame;
}

/// Vertex in column x and row y of grid_sheet(), a sheet of columns x rows squares with sides of `edge`, m. A
/// diagonal from the lower left to the upper right corner divides each square.
inline Index grid_vertex(Index rows, Index x, Index y) {
    return x * (rows + 1) + y;
}
inline Snapshot grid_sheet(Index columns, Index rows, double edge = 1) {
    Positions position(3, (columns + 1) * (rows + 1));
    for (Index x = 0; x <= columns; ++x)
        for (Index y = 0; y <= rows; ++y) position.col(grid_vertex(rows, x, y)) << edge * x, edge * y, 0;
    std::vector<std::array<Index, 3>> faces;
    for (Index x = 0; x < columns; ++x)
        for (Index y = 0; y < rows; ++y) {
            const Index corner = grid_vertex(rows, x, y), next = grid_vertex(rows, x + 1, y);
            faces.push_back({corner, next, next + 1});
            faces.push_back({corner, next + 1, corner + 1});
        }
    return whole_sheet(position, faces);
}

/// Vertex of polar_sheet() in a ring, from 1, at the angle 2 pi sector / sectors. The sheet is a disk about
/// the origin, with vertex 0 in the centre and rings of `sectors` vertices at the radii 1, 2, ..., `rings`,
/// m.
inline Index polar_vertex(Index sectors, Index ring, Index sector) {
    return 1 + (ring - 1) * sectors + sector % sectors;
}
inline Snapshot polar_sheet(Index rings, Index sectors) {
    Positions position = Positions::Zero(3, 1 + rings * sectors);
    std::vector<std::array<Index, 3>> faces;
    for (Index s = 0; s < sectors; ++s) {
        const double angle = 2 * std::numbers::pi * s / sectors;
        for (Index r = 1; r <= rings; ++r)
            position.col(polar_vertex(sectors, r, s)) << r * std::cos(angle), r * std::sin(angle), 0;
        faces.push_back({0, polar_vertex(sectors, 1, s), polar_vertex(sectors, 1, s + 1)});
        for (Index r = 1; r < rings; ++r) {
            const Index corner = polar_vertex(sectors, r, s), beside = polar_vertex(sectors, r, s + 1);
            faces.push_back({corner, corner + sectors, beside + sectors});
            faces.push_back({corner, beside + sectors, beside});
        }
    }
    return whole_sheet(position, faces);
}

/// Lets the edges along a path of vertices fail without opening.
inline void crack(Snapshot& frame, std::span<const Index> path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        frame.edges.push_back({path[i], path[i + 1]});
        frame.edge_state.push_back(EdgeState::fractured_interior);
        frame.edge_strain.push_back(0);
    }
}
inline void crack(Snapshot& frame, const std::vector<Index>& path) {
    crack(frame, std::span<const Index>(path));
}

}  // namespace sherd::test
