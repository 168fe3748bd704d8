// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/build/start_fault.h"
#include "app/scene/scene.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Sees to it that sheets that meet each other start apart, with half their thickness on either side. Those
/// that lack a little are moved, each as a whole along the normal of contact, by a twentieth of the thickness
/// at most, with a warning that says which and how far; of two, the upper one, and never one that is held.
/// Where that does not do it throws Error naming faces (numbered from 0 in each sheet) that cross, or that
/// are too near. inputs: of all sheets, in the scene's order; all: made of them, and made anew when one is
/// moved.
void part_sheets(const Scene& scene, std::vector<SheetInput>& inputs, BreakableShell& all,
                 std::vector<std::string>& warnings);

/// The faces for which part_sheets() throws, two of each pair, one after the other.
std::vector<StartFault> sheet_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all);

}  // namespace sherd
