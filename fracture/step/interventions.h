// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/forces/shell_energies.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

// Checks and changes for the actions of a calling program between two steps: see Simulation.

/// Throws Error unless ShellEnergyOptions::given_forces is set and there is one force for each vertex.
void require_forces(const ShellEnergyOptions& options, const Shell& shell, const Positions& forces);
/// Throws Error if an edge has no hinge or is given twice.
void require_hinges(const BreakableShell& shell, std::span<const Edge> edges);
/// Gives each of `vertices` a straight motion from its position at `now` (s) to its column of `positions`,
/// [3, n] m, at `then` (s). shared: the first `shared` motions of the shell may belong to clamps, too, and
/// are not changed. Throws Error if no pin holds a vertex in all directions, or if `then` is not later than
/// `now`.
void prescribe(Shell& shell, std::size_t shared, std::span<const Index> vertices, const Positions& positions,
               double now, double then);

}  // namespace sherd
