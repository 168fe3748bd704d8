// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/sheet_input.h"

namespace sherd {

/// Gives a sheet, whose mesh is placed, the thickness of its map, if it has one, and its material the mean.
/// Throws Error naming the scene's line and key, and where the sheet is not thicker than nothing; warnings
/// are sentences.
void set_thickness(const SheetSpec& sheet, SheetInput& input, std::vector<std::string>& warnings);

/// "0.003", or "0.002 to 0.006", to be followed by its unit.
std::string thickness_words(const SheetInput& input);

/// The material where the sheet is thickest.
Material thickest_material(const SheetInput& input);

/// The thinnest and the thickest of some sheets, m.
struct ThicknessRange {
    double thinnest, thickest;
};
ThicknessRange thickness_range(const std::vector<SheetInput>& inputs);

}  // namespace sherd
