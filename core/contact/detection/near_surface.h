// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// The columns of x [3, V] m, ascending, that are nearer to triangles on `points` [3, P] m than their reach
/// [V] m; columns with a negative reach never are.
std::vector<Index> near_surface(const Positions& points, const std::vector<std::array<Index, 3>>& triangles,
                                const Positions& x, const VectorXd& reach);

}  // namespace sherd
