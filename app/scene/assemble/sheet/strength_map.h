// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns factors of the strength [E] from edge_values() of a sheet's map; infinite where the map says
/// `never`. Throws Error, naming the scene's line and key, like edge_values(), and on a value that is
/// negative or not finite.
std::vector<double> map_factors(const StrengthMap& map, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings);

}  // namespace sherd
