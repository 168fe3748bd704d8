// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Returns the numbers, ascending, of the points x ([3, V] m) whose distance from `triangles` on `points`
/// ([3, P] m) is less than the points' `reach` ([V] m). Points with a negative reach are never returned.
std::vector<Index> near_surface(const Positions& points, const std::vector<std::array<Index, 3>>& triangles,
                                const Positions& x, const VectorXd& reach);

}  // namespace sherd
