// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Vertices and edges that must stay while triangles are changed.
struct LineConstraints {
    /// Vertices that may not move, such as vertices of cracks, pins and gauges. By default any vertex may
    /// move.
    std::function<bool(Vertex)> is_fixed_vertex = [](Vertex) { return false; };
    /// Edges that stay, called lines: they may be split, but are not flipped. A vertex between two collinear
    /// lines may slide along them; other vertices of lines stay.
    std::function<bool(Edge)> is_line = [](Edge) { return false; };
    /// Edges with a dihedral angle above this, in degrees, are lines, too.
    double crease = 40;
};

/// Whether an edge is a line by `lines.is_line` or because it is creased, is on the boundary, or separates
/// faces of different groups, materials or texture coordinates.
bool is_constrained_line(const Mesh& mesh, Edge edge, const LineConstraints& lines);

/// Freedom of a vertex to move.
enum class Mobility : std::uint8_t { fixed, slides, free };

/// A separate mesh with copies of the faces near some vertices of a mesh, called the large mesh here, so that
/// changes can be tried.
struct Patch {
    Mesh mesh;
    std::vector<Vertex> vertices;    ///< vertex of the large mesh that each vertex copies
    std::vector<Mobility> mobility;  ///< for each vertex of the patch
    std::vector<char> line;          ///< for each edge of the patch: 1 for lines and for the rim of the patch
    std::vector<char> rim;           ///< for each edge of the patch: 1 where the large mesh continues

    /// Returns the vertex of the patch that copies a vertex of the large mesh; the null vertex if none does.
    Vertex local(Vertex vertex) const;
};

/// Returns the patch of the faces at `centres` and at the neighbours of these. Vertices with further faces,
/// outside of the patch, are fixed.
Patch patch_around(const Mesh& mesh, std::span<const Vertex> centres, const LineConstraints& lines);

}  // namespace sherd
