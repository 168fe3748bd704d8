// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Lets positions and velocities [3, V] of a shell, which has its new masses already, follow a change of its
/// triangles. Where vertices have moved or masses have changed, the patch then gets a rigid motion in
/// addition, so that it has the linear momentum, and the angular momentum about its centre of mass, that it
/// had. Supports take the part of held vertices: otherwise one or two free vertices beside a support would
/// get far too large velocities. About another point the angular momentum changes by the displacement of the
/// centre of mass, which corners of curved triangles move, times the linear momentum: it cannot be kept in
/// all frames.
void follow_in_motion(const Shell& shell, const ShellChange& change, Positions& position,
                      Positions& velocity);

}  // namespace sherd
