// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <variant>

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

}  // namespace sherd
