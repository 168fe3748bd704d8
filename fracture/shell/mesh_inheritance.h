// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/shell/shell.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// Corners of a face in the order of Shell::triangles.
std::array<Index, 3> face_vertices(const Mesh& mesh, Face face);

/// Returns the change of a shell that corresponds to the change `topology` of its mesh, without removed and
/// reshaped hinges. mesh: the mesh after the change; before: the shell before the change.
ShellChange shell_change(const Mesh& mesh, const TopologyChange& topology, const Shell& before);

/// The edges of changed faces before a change of the mesh.
class OldSides {
  public:
    /// mesh: the mesh after the change; before: the shell before it. All arguments must outlive this object.
    OldSides(const Mesh& mesh, const TopologyChange& topology, const Shell& before);

    /// Returns the old edge between two old corners of a changed face; if the edge was split, the half that
    /// keeps its number. The result is invalid if there is no such edge.
    Edge between(Index from, Index to) const;
    /// Returns the old edges of all parents of the two faces beside `edge`, each edge once.
    std::vector<Edge> around(Edge edge) const;

  private:
    const Mesh& mesh;
    const TopologyChange& topology;
    const Shell& before;
    std::vector<std::pair<std::array<Index, 2>, Edge>> flipped;  ///< flipped edges, with their old ends
};

}  // namespace sherd
