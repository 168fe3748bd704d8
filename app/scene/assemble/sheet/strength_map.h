// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the factors of a sheet's map of strength or toughness [E], computed from edge_values(); a factor
/// is infinite where StrengthMap::never lets nothing break. Throws Error, naming the scene's line and key,
/// like edge_values(), and on a value that is negative or not finite.
std::vector<double> map_factors(const StrengthMap& map, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings);

}  // namespace sherd
