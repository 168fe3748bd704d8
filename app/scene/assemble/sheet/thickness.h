// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/shell/sheet_input.h"

namespace sherd {

/// Sets the thickness of a sheet from its map, if it has one, and that of its material to the mean. input:
/// with the placed mesh. Throws Error naming the scene's line and key, also where the thickness is not
/// positive; warnings are sentences.
void set_thickness(const SheetSpec& sheet, SheetInput& input, std::vector<std::string>& warnings);

/// The thickness in words without its unit: "0.003", or "0.002 to 0.006".
std::string thickness_text(const SheetInput& input);

/// The sheet's material with its largest thickness.
Material thickest_material(const SheetInput& input);

/// The smallest and the largest thickness of some sheets, m.
struct ThicknessRange {
    double thinnest, thickest;
};
ThicknessRange thickness_range(const std::vector<SheetInput>& inputs);

}  // namespace sherd
