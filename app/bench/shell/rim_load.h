// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/loads.h"

namespace sherd {

// Loads on a side of the outline of a sheet in the plane z = 0, as if the sheet continued beyond the outline.
// The outward direction is away from the origin.

/// Adds the forces of a membrane stress to `load`. stress: N/m, integral over the thickness.
void add_rim_stress(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& stress, Load& load);

/// Adds the moments and forces of bending to `load`. moments: N, positive where they stretch the side z > 0;
/// shear: N/m, shear force, the divergence of the moments. The twisting moment becomes a couple of forces at
/// the ends of the side.
void add_rim_moments(const Shell& shell, const TriangleEdge& side, const Eigen::Matrix2d& moments,
                     const Vector2d& shear, Load& load);

/// The middle of a side at rest, m.
Vector2d middle_of(const Shell& shell, const TriangleEdge& side);

/// Returns, for each vertex [V], 1 if it lies on the bounding rectangle of the sheet at rest, else 0.
std::vector<char> on_bounding_rectangle(const Shell& shell);

}  // namespace sherd
