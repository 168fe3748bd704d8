// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Vertices and edges that must stay where triangles are changed.
struct LineConstraints {
    /// Vertices that do not move: of cracks, pins, gauges. By default any may.
    std::function<bool(Vertex)> is_fixed_vertex = [](Vertex) { return false; };
    /// Edges that stay, called lines: they may be split, but are not flipped. A vertex between two collinear
    /// lines may slide along them; vertices at other ends of lines stay.
    std::function<bool(Edge)> is_line = [](Edge) { return false; };
    /// Edges with a dihedral angle above this, in degrees, are lines, too.
    double crease = 40;
};

/// Whether an edge is one of the lines, or creased, or on the boundary, or separates faces of different
/// groups, materials or texture coordinates.
bool is_constrained_line(const Mesh& mesh, Edge edge, const LineConstraints& lines);

/// Freedom of a vertex to move.
enum class Mobility : std::uint8_t { fixed, slides, free };

/// A separate mesh of the faces near some vertices, on which changes can be tried.
struct Patch {
    Mesh mesh;
    std::vector<Vertex> vertices;    ///< vertex of the large mesh for each vertex of the patch
    std::vector<Mobility> mobility;  ///< for each vertex of the patch
    std::vector<char> line;          ///< for each edge of the patch: 1 for lines and for the rim of the patch
    std::vector<char> rim;           ///< for each edge of the patch: 1 where the large mesh continues

    /// The patch's vertex for one of the large mesh; null if it is not in the patch.
    Vertex local(Vertex vertex) const;
};

/// Faces within two edges of `centres`. Vertices that have faces outside are fixed.
Patch patch_around(const Mesh& mesh, std::span<const Vertex> centres, const LineConstraints& lines);

}  // namespace sherd
