// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/reaction.h"
#include "core/shell/shell.h"

namespace sherd {

/// The part of a vertex's displacement that pins and guides permit.
inline Vector3d constrained(const Shell& shell, Index vertex, const Vector3d& displacement) {
    if (shell.fixed[vertex]) return Vector3d::Zero();
    if (shell.guide[vertex] == 0) return displacement;
    return shell.guides[shell.guide[vertex] - 1] * displacement;
}

/// Removes from a displacement (or a gradient) [3, V] the components that pins and guides block.
void constrain(const Shell& shell, Positions& displacement);

/// Moves the vertices with prescribed motions in x [3, V] to their places at `time` (s); other vertices stay.
void place_scripted(const Shell& shell, double time, Positions& x);

/// A displacement [3, V] restricted to vertices with prescribed motions; zero for other vertices.
Positions scripted_part(const Shell& shell, const Positions& displacement);

/// Adds the forces [3, V] N on held vertices at x [3, V] m to the reactions of the supports that hold them: a
/// support gets the components in the directions in which it holds the vertex.
void add_reactions(const Shell& shell, const Positions& x, const Positions& forces,
                   std::span<Reaction> of_supports);

}  // namespace sherd
