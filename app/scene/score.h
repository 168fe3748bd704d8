// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// A list of edges, see read_edge_list.
struct ScoreFile {
    std::filesystem::path path;
};

/// A polyline in the mesh's own frame, m.
struct ScoreLine {
    std::vector<Eigen::Vector3d> points;
};

/// Where a sheet was scored, and what this does to its strength.
struct Score {
    std::variant<ScoreFile, ScoreLine> kind;
    double factor = 1;  ///< times the strength
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// The edges that are scored, each once. Throws Error naming the scene's line and key on a list of edges for
/// a mesh that is not as in its file, and on what read_edge_list and edge_path throw on.
std::vector<Edge> scored_edges(const Score& score, const Mesh& placed, const Eigen::Isometry3d& place);

}  // namespace sherd
