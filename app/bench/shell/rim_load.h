// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/loads.h"

namespace sherd {

// Loads on a side of the outline of a sheet in the plane z = 0 that continues beyond it. The outline is
// seen from the origin.

/// stress: N/m, over the thickness.
void add_rim_stress(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& stress, Load& load);

/// moments: N, positive where they stretch the side z > 0; shear: N/m, their divergence. The twist along the
/// side is a couple of forces at its ends.
void add_rim_moments(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& moments,
                     const Vector2d& shear, Load& load);

/// The middle of a side at rest.
Vector2d middle_of(const Shell& shell, const TriangleEdge& side);

/// [V] 1 of vertices on the rectangle around the whole sheet.
std::vector<char> on_bounding_rectangle(const Shell& shell);

}  // namespace sherd
