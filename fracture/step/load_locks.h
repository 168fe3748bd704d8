// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/shell_energies.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Protects the geometry of loads and winds from changes of the mesh: vertices under forces, boundary edges
/// under moments, and the borders of faces under pressure or in a wind.
void lock_load_geometry(BreakableShell& sheets, const ShellEnergyOptions& options);

}  // namespace sherd
