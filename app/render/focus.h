// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/snapshot.h"

namespace sherd {

/// The box (m) of a frame that a camera should show: around every fragment but the strays of each sheet,
/// small pieces that are farther from its middle than the rest. Strays have at most a twentieth of their
/// sheet's area, so that a sheet in one or in a few large pieces has none. Vertices that are not finite are
/// left out; empty when none is.
Eigen::AlignedBox3d focus_box(const Snapshot& frame);

}  // namespace sherd
