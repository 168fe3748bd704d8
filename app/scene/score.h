// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/scene/fracture_law.h"

namespace sherd {

/// A list of edges, see read_edge_list.
struct ScoreFile {
    std::filesystem::path path;
};

/// A polyline in the mesh's own frame, m.
struct ScoreLine {
    std::vector<Eigen::Vector3d> points;
};

/// A scored line of a sheet, and its effect on strength or toughness.
struct Score {
    std::variant<ScoreFile, ScoreLine> kind;
    double factor = 1;  ///< times the strength, or the toughness
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
