// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/shell/shell.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// Corners of a face in the order of Shell::triangles.
std::array<Index, 3> face_vertices(const Mesh& mesh, Face face);

/// The change of a shell that corresponds to a change of the mesh. mesh: after the change; before: the shell,
/// which has not followed yet. Reshaped hinges are not included.
ShellChange shell_change(const Mesh& mesh, const TopologyChange& topology, const Shell& before);

/// The edges of changed faces before the change.
class OldSides {
  public:
    /// mesh: after the change. All arguments must outlive this object.
    OldSides(const Mesh& mesh, const TopologyChange& topology, const Shell& before);

    /// The old edge between two old corners of a changed face; if it was split, the half that has its number.
    /// Invalid if there is none.
    Edge between(Index from, Index to) const;
    /// The old edges of the parents of the faces beside `edge`, each once.
    std::vector<Edge> around(Edge edge) const;

  private:
    const Mesh& mesh;
    const TopologyChange& topology;
    const Shell& before;
    std::vector<std::pair<std::array<Index, 2>, Edge>> flipped;  ///< their old ends
};

}  // namespace sherd
