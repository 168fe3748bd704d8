// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/scene/assemble/start/start_fault.h"
#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Returns all faces of the sheets that keep a scene from starting: overlaps of sheets with each other and
/// with obstacles. The inputs are those of all sheets, made by make_sheet(); `all` is made from them.
std::vector<StartFault> start_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all);

}  // namespace sherd
