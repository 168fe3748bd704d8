// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/sheet.h"

namespace sherd {

/// Removes from a displacement (or a gradient) [3, V] the components that pins and guides block.
void constrain(const Sheet& sheet, Positions& displacement);

/// Moves the scripted vertices in x [3, V] to where they are at `time` (s); the others stay.
void place_carried(const Sheet& sheet, double time, Positions& x);

/// A displacement [3, V] restricted to scripted vertices; zero for the others.
Positions carried_part(const Sheet& sheet, const Positions& displacement);

}  // namespace sherd
