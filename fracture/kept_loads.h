// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/shell_energies.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Lets what loads and winds refer to stay where triangles change: vertices under forces, sides under moments
/// (of the boundary), and the borders of what is under pressure or in a wind.
void keep_loads(BreakableShell& sheets, const ShellEnergyOptions& options);

}  // namespace sherd
