// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// What must stay where triangles are changed.
struct KeptLines {
    /// Vertices that do not move: of cracks, pins, gauges. By default any may.
    std::function<bool(Vertex)> keeps_place = [](Vertex) { return false; };
    /// Edges that stay, as lines: they may be split, but are not flipped. A vertex of two that are in line
    /// may slide along them; at other ends of lines vertices stay.
    std::function<bool(Edge)> is_line = [](Edge) { return false; };
    /// Edges where the sheet is folded by more than this, in degrees, are lines, too.
    double crease = 40;
};

/// Whether an edge is one of the lines, or on the boundary, or separates faces of different groups or texture
/// coordinates.
bool is_kept_line(const Mesh& mesh, Edge edge, const KeptLines& lines);

/// How a vertex may move.
enum class Mobility : std::uint8_t { fixed, slides, free };

/// A small mesh of its own of the faces near some vertices, to try changes on.
struct Patch {
    Mesh mesh;
    std::vector<Vertex> vertices;    ///< of the large mesh, for each of the patch
    std::vector<Mobility> mobility;  ///< of the patch's vertices
    std::vector<char> line;          ///< of its edges: 1 for lines and for the rim of the patch
    std::vector<char> rim;           ///< of its edges: 1 where the large mesh goes on

    /// The patch's vertex for one of the large mesh; null if it is not in the patch.
    Vertex local(Vertex vertex) const;
};

/// Faces within two edges of `centres`. Vertices that have faces outside are fixed.
Patch patch_around(const Mesh& mesh, std::span<const Vertex> centres, const KeptLines& lines);

}  // namespace sherd
