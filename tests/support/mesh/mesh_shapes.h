// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "meshops/mesh.h"

namespace sherd::test {

inline std::vector<std::array<int, 3>> triangles_of(const Mesh& mesh) {
    std::vector<std::array<int, 3>> triangles;
    for (const Face face : mesh.faces()) {
        std::array<int, 3> corners;
        int i = 0;
        for (const Vertex vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            corners[i++] = static_cast<int>(vertex.idx());
        triangles.push_back(corners);
    }
    return triangles;
}

/// Grid of columns x rows squares of two triangles each, in the plane z = 0. Optionally opposite sides are
/// joined, so that its topology (but not its shape) is a tube or a torus.
inline Mesh grid(int columns, int rows, bool wrap_columns = false, bool wrap_rows = false) {
    Mesh mesh;
    const int across = wrap_columns ? columns : columns + 1, along = wrap_rows ? rows : rows + 1;
    std::vector<Vertex> vertices;
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < across; ++i) vertices.push_back(mesh.add_vertex(Point(i, j, 0)));
    const auto at = [&](int i, int j) { return vertices[(j % along) * across + i % across]; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
    return mesh;
}

/// Closed surface of eight faces.
inline Mesh octahedron() {
    Mesh mesh;
    std::vector<Vertex> v;
    for (const Point& p :
         {Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)})
        v.push_back(mesh.add_vertex(p));
    for (int i = 0; i < 4; ++i) {
        mesh.add_face(v[i], v[(i + 1) % 4], v[4]);
        mesh.add_face(v[(i + 1) % 4], v[i], v[5]);
    }
    return mesh;
}

}  // namespace sherd::test
