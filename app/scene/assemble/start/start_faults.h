// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/scene/assemble/start/start_fault.h"
#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Returns all faces of sheets that keep a scene from starting, since they overlap other faces or obstacles.
/// inputs: all sheets, made by make_sheet(); `all` is made from them.
std::vector<StartFault> start_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all);

}  // namespace sherd
