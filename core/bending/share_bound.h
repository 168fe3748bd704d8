// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Bound on the curvature, 1/m, along a side of this length (m) that SideCurvature finds where no fold is
/// turned by more than `angle` (rad): most sheets are so flat that this bound suffices.
double most_side_curvature(double length, double angle);

}  // namespace sherd
