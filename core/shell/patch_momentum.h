// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Lets positions and velocities [3, V] of a shell, which has its new masses already, follow a change of its
/// triangles. Where vertices have moved or masses have changed, the vertices that nothing holds then get a
/// rigid motion in addition, so that the patch has the linear momentum, and the angular momentum about its
/// centre of mass, that it had; as far as they can, if there are fewer than three of them or if they are in
/// line. About another place the angular momentum changes by the way of the centre of mass, which curved
/// triangles' corners move, times the linear one: it cannot stay in all frames.
void follow_in_motion(const Shell& shell, const ShellChange& change, Positions& position,
                      Positions& velocity);

}  // namespace sherd
