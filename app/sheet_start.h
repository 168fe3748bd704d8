// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene.h"
#include "fracture/breakable_sheet.h"

namespace sherd {

/// Throws Error naming faces of the scene's sheets (numbered from 0 in each) that cross, or that are nearer
/// to each other than half the sum of their thicknesses. `all`: the sheets in the scene's order, as they
/// start.
void require_sheets_apart(const Scene& scene, const BreakableSheet& all);

}  // namespace sherd
