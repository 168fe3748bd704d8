// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Returns the box (m) that a camera should show in a frame: around all fragments except outliers. Outliers
/// are small fragments that are farther from the middle of their sheet than the sheet's other fragments. They
/// have at most a twentieth of their sheet's area together, so that a sheet in one or in a few large
/// fragments has none. Vertices that are not finite are left out; the box is empty if no vertex is finite.
Eigen::AlignedBox3d focus_box(const Snapshot& frame);

}  // namespace sherd
