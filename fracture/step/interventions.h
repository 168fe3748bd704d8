// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/forces/shell_energies.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

// Checks and changes for what a program does between two steps: see Simulation.

/// Throws Error without ShellEnergyOptions::given_forces, and if the number of forces is not that of
/// vertices.
void require_forces(const ShellEnergyOptions& options, const Shell& shell, const Positions& forces);
/// Throws Error if an edge has no hinge or is given twice.
void require_hinges(const BreakableShell& shell, std::span<const Edge> edges);
/// Gives vertices a motion from their places at `now` to `positions` [3, n] m at `then` (s). shared: number
/// of the first motions of the shell that may belong to clamps, too, and are not changed. Throws Error if a
/// vertex is not held in all directions, or if `then` is not later than `now`.
void prescribe(Shell& shell, std::size_t shared, std::span<const Index> vertices, const Positions& positions,
               double now, double then);

}  // namespace sherd
