// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Returns the sheets between two frames of a recording, at 0 < share < 1 of the time between them.
///
/// The mesh is that of the later frame. Each vertex moves in a straight line to its place there: from its
/// place in the earlier frame or, if a crack made it in between, from that of the vertex that was split, or,
/// if it was inserted, from its place in the edge or face that was split (frame_parents()). So nothing jumps
/// at a frame and no face is stretched over a crack: the crack opens from closed to its width in the later
/// frame. Fragments and edge states are those of the earlier frame until the later one is reached.
/// Velocities, and strains of hinges that do not fail in between, are interpolated; the strain of a hinge
/// within a face that is split in between grows from 0. Fields of faces are interpolated, too; a part of a
/// face begins with the fields of the whole.
///
/// Throws Error (input) if the frames are not those of one run, in this order.
Snapshot interpolated(const Snapshot& earlier, const Snapshot& later, double share);

/// Returns the pose between two others: `pivot` (m, in the body's own frame) moves in a straight line, and
/// the body turns about it at constant speed, by the smaller angle. Returns the earlier pose if one of them
/// is not finite.
Eigen::Isometry3d interpolated(const Eigen::Isometry3d& earlier, const Eigen::Isometry3d& later, double share,
                               const Vector3d& pivot);

}  // namespace sherd
