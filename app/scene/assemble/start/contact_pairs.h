// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/scene/scene.h"
#include "fracture/shell/sheet_input.h"

namespace sherd {

/// Throws Error (input), naming the sheet and a remedy, if the edges of a sheet are so much shorter than its
/// thickness that contact would have more candidate pairs than memory and time allow. inputs: made from the
/// scene's sheets, in the scene's order.
void require_few_pairs(const Scene& scene, const std::vector<SheetInput>& inputs);

}  // namespace sherd
