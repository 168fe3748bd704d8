// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Returns the box (m) of a frame that a camera should show: around all fragments but the outliers of each
/// sheet, small fragments that are farther from its middle than the rest. Outliers have at most a twentieth
/// of their sheet's area, so that a sheet in one or in a few large fragments has none. Vertices that are not
/// finite are left out; the box is empty if no vertex is finite.
Eigen::AlignedBox3d focus_box(const Snapshot& frame);

}  // namespace sherd
