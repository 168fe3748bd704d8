// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sherd {

/// Grey values, the mean of the three colours, of a PNG file over the mesh's texture coordinates.
struct MapTexture {
    std::filesystem::path path;
};

/// Values of a float grid of an OpenVDB file in the frame of the mesh file.
struct MapGrid {
    std::filesystem::path path;
    std::string name = {};  ///< empty: the only float grid
};

/// A property of the vertices of the sheet's own PLY file.
struct MapProperty {
    std::string name;
};

/// Source of the values of a map over a sheet.
using MapSource = std::variant<MapTexture, MapGrid, MapProperty>;

/// Property that a map or a scored line multiplies: strength, at which cracks nucleate, or toughness, at
/// which they propagate.
enum class FractureLaw { strength, toughness };

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

/// Strength or toughness of a sheet from place to place.
struct StrengthMap {
    MapSource source;
    /// The factors of the values 0 and 1, linear between them; values above 1 count as 1. Without them the
    /// values are factors themselves.
    std::optional<Eigen::Vector2d> range;
    bool never = false;  ///< instead: nothing breaks where the value is a half or more
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// Thickness of a sheet from place to place.
struct ThicknessMap {
    MapSource source;
    /// Thickness for the values 0 and 1, m, linear between them; values above 1 count as 1.
    std::optional<Eigen::Vector2d> range;
    double scale = 1;   ///< m, thickness for the value 1, without range
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
