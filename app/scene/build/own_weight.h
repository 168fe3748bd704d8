// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Warns of supported sheets whose weight at rest is more than half of what they bear: it acts from time 0
/// on, and a sheet that begins without it swings to twice its sag. Statics of the sheet alone tell, without
/// obstacles and other loads; where they find no rest, as of cloth and of what can turn, nothing is said.
/// Inputs are those of the scene, in its order.
void warn_of_own_weight(const Scene& scene, const std::vector<SheetInput>& inputs,
                        std::vector<std::string>& warnings);

}  // namespace sherd
