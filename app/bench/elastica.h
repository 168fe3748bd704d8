// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// Where the tip of an inextensible cantilever of length 1 and rigidity 1 comes to rest under a dead load q a
/// length, which acts across it: what it moves back along the cantilever, and what it sinks. From
/// angle'' = -q (1 - s) cos(angle), angle(0) = 0, angle'(1) = 0, to ten digits.
Vector2d elastica_tip(double q);

}  // namespace sherd
