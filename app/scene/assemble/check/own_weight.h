// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Warns of supported, breakable sheets in which the static stress under their own weight exceeds half the
/// strength. The weight acts from time 0 on, so that a sheet, which starts undeformed, oscillates up to twice
/// its static sag. The stress is computed by statics of the sheet alone, without obstacles and other loads;
/// there is no warning if statics find no equilibrium, as for cloth and for sheets that can rotate. inputs:
/// made from the scene's sheets, in the scene's order.
void warn_of_own_weight(const Scene& scene, const std::vector<SheetInput>& inputs,
                        std::vector<std::string>& warnings);

}  // namespace sherd
