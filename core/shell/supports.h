// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/sheet.h"

namespace sherd {

/// Takes away of a displacement (or a gradient) [3, V] what pins and guides do not let through.
void constrain(const Sheet& sheet, Positions& displacement);

/// Puts the vertices that motions carry where they are at `time` (s); the others stay as they are in x [3,
/// V].
void place_carried(const Sheet& sheet, double time, Positions& x);

/// What a displacement [3, V] has of vertices that motions carry; zero for the others.
Positions carried_part(const Sheet& sheet, const Positions& displacement);

}  // namespace sherd
