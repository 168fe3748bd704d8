// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Lets positions and velocities [3, V] of a shell, which has its new masses already, follow a change of its
/// triangles. Where vertices have moved or masses have changed, the patch then gets a rigid motion in
/// addition, so that it has the linear momentum, and the angular momentum about its centre of mass, that it
/// had. What holds vertices takes their part of it: were it the others', one or two of them beside a support
/// would fly off. About another place the angular momentum changes by the way of the centre of mass, which
/// curved triangles' corners move, times the linear one: it cannot stay in all frames.
void follow_in_motion(const Shell& shell, const ShellChange& change, Positions& position,
                      Positions& velocity);

}  // namespace sherd
