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
/// at most, with a warning that says which and how far. Of two sheets the upper one is moved, and never one
/// that is held. Where that is not enough all stay, and what overlaps is exempt from contact until it is
/// apart, with a warning that names faces (numbered from 0 in each sheet) that cross or are too near; with
/// ContactSpec::exempt unset it throws Error instead. The inputs are those of all sheets, in the scene's
/// order; `all` is made of them, and is made anew when one is moved.
void part_sheets(const Scene& scene, std::vector<SheetInput>& inputs, BreakableShell& all,
                 std::vector<std::string>& warnings);

/// Returns the faces that part_sheets() exempts, or throws for: two of each pair, one after the other.
std::vector<StartFault> sheet_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all);

}  // namespace sherd
