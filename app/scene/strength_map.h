// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sherd {

/// Grey values from 0 to 1 (mean of red, green and blue) of a PNG file, found by the mesh's texture
/// coordinates.
struct MapTexture {
    std::filesystem::path path;
};

/// Values of a float grid in an OpenVDB file, in the frame and unit of the mesh file.
struct MapGrid {
    std::filesystem::path path;
    std::string name = {};  ///< name of the grid; empty: the only float grid in the file
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

/// File with a list of edges: see read_edge_list().
struct ScoreFile {
    std::filesystem::path path;
};

/// A polyline in the frame of the mesh before it is placed, m.
struct ScoreLine {
    std::vector<Eigen::Vector3d> points;
};

/// A scored line of a sheet, and its effect on strength or toughness.
struct Score {
    std::variant<ScoreFile, ScoreLine> kind;
    double factor = 1;  ///< factor on the strength, or on the toughness
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// A map of the strength or the toughness over a sheet.
struct StrengthMap {
    MapSource source;
    /// Factors for the values 0 and 1, linear between them; values above 1 count as 1. None: the values are
    /// the factors.
    std::optional<Eigen::Vector2d> range;
    bool never = false;  ///< whether, instead of factors, nothing breaks where the value is 0.5 or more
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// A map of the thickness over a sheet.
struct ThicknessMap {
    MapSource source;
    /// Thickness, m, for the values 0 and 1, linear between them; values above 1 count as 1. None: by
    /// `scale`.
    std::optional<Eigen::Vector2d> range;
    double scale = 1;   ///< m, thickness for the value 1 if there is no range
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
