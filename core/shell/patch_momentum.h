// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Lets positions, [3, V] m, and velocities, [3, V] m/s, of a shell follow a change of its triangles; the
/// shell must have its new masses already. The patch of changed triangles then gets a rigid motion in
/// addition, so that it keeps its linear momentum, and its angular momentum about its centre of mass. Held
/// vertices do not get this motion, and their supports take their part of the momentum: if it went to the
/// free vertices, one or two of them beside a support would get far too large velocities. New corners of
/// curved triangles displace the centre of mass. About another point the angular momentum changes by this
/// displacement times the linear momentum: it cannot be kept in all frames.
void follow_in_motion(const Shell& shell, const ShellChange& change, Positions& position,
                      Positions& velocity);

}  // namespace sherd
