// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Returns the sheets at a moment between two frames of a recording. share: fraction of the time between the
/// frames that has passed, between 0 and 1.
///
/// The mesh is the later frame's. Each vertex moves in a straight line to its position in the later frame. It
/// starts in its position in the earlier frame; if a crack has made it since then, in the position of the
/// vertex that was split; or if it has been inserted, in its place in the edge or face that was split
/// (frame_parents()). So nothing jumps at a frame, and no face is stretched over a crack: a crack opens from
/// closed to its width in the later frame. Fragments and edge states are those of the earlier frame until the
/// later one is reached. Velocities are interpolated, and so are strains of hinges that do not fail in
/// between; the strain of a hinge inside a face that is split in between grows from 0. Fields of faces are
/// interpolated, too; a part of a face begins with the fields of the whole.
///
/// Throws Error (input) if these are not frames of one run in this order.
Snapshot interpolated(const Snapshot& earlier, const Snapshot& later, double share);

/// Returns the pose of a body between its poses `earlier` and `later`: `pivot` (m, in the body's own frame)
/// moves in a straight line, and the body turns about it at constant speed, by the smaller angle. share:
/// fraction of the time between the poses that has passed. Returns the earlier pose if one of them is not
/// finite.
Eigen::Isometry3d interpolated(const Eigen::Isometry3d& earlier, const Eigen::Isometry3d& later, double share,
                               const Vector3d& pivot);

}  // namespace sherd
