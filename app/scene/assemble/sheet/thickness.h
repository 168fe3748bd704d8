// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/shell/sheet_input.h"

namespace sherd {

/// If the sheet has a map of the thickness, sets the thickness of the input's vertices from it, and the
/// thickness of its material to the mean. input: has the placed mesh. Throws Error, naming the scene's line
/// and key, like vertex_values(), and where the thickness is not positive; warnings are sentences.
void set_thickness(const SheetSpec& sheet, SheetInput& input, std::vector<std::string>& warnings);

/// Returns the thickness of a sheet, in m, as text without the unit: "0.003", or "0.002 to 0.006".
std::string thickness_text(const SheetInput& input);

/// Returns the sheet's material with the sheet's largest thickness.
Material thickest_material(const SheetInput& input);

/// Smallest and largest thickness of some sheets, m.
struct ThicknessRange {
    double thinnest, thickest;
};
ThicknessRange thickness_range(const std::vector<SheetInput>& inputs);

}  // namespace sherd
