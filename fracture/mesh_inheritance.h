// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/shell/shell.h"
#include "meshops/topology_change.h"

namespace sherd {

/// Corners of a face in the order of Shell::triangles.
std::array<Index, 3> face_vertices(const Mesh& mesh, Face face);

/// What a change of the mesh means for a shell that has not followed it yet. Hinges that the change reshapes
/// are not in it.
ShellChange shell_change(const TopologyChange& topology, const Shell& before);

/// The edges of changed faces as they were.
class OldSides {
  public:
    /// mesh: after the change. It must outlive this object, as the others must.
    OldSides(const Mesh& mesh, const TopologyChange& topology, const Shell& before);

    /// The old edge between two old corners of a changed face; of a split one the half that has its number.
    /// Invalid: there is none.
    Edge between(Index from, Index to) const;
    /// The old edges of the old faces in which `edge` lies now, each once.
    std::vector<Edge> around(Edge edge) const;

  private:
    const Mesh& mesh;
    const TopologyChange& topology;
    const Shell& before;
    std::vector<std::pair<std::array<Index, 2>, Edge>> flipped;  ///< ends that they had
};

}  // namespace sherd
