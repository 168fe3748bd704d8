// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/assemble/start/start_fault.h"
#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Makes sheets that collide with each other (contact.sheets) start apart, with half their thickness on
/// either side of their mesh. Sheets that overlap a little are moved, each as a whole along the normal of
/// contact, by at most a twentieth of the thickness, with a warning that names sheet and displacement. Of two
/// sheets the upper one is moved, and never a supported one. If this does not suffice, all sheets stay, and
/// overlapping faces are exempt from contact until they have separated, with a warning that names faces
/// (numbered from 0 in each sheet) that intersect or are too near; if Scene::exempts_overlaps is not set, an
/// Error is thrown instead. inputs: all sheets, in the scene's order; `all` is made from them, and made again
/// if a sheet is moved.
void separate_overlapping_sheets(const Scene& scene, std::vector<SheetInput>& inputs, BreakableShell& all,
                                 std::vector<std::string>& warnings);

/// Returns the faces that separate_overlapping_sheets() exempts, or for which it throws: both faces of each
/// overlapping pair, one after the other.
std::vector<StartFault> sheet_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all);

}  // namespace sherd
