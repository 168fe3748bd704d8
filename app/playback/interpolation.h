// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "fracture/snapshot.h"

namespace sherd {

/// The sheets between two frames of a recording, at 0 < share < 1 of the way.
///
/// The mesh is that of the later frame. Each vertex goes in a straight line to its place there: from its
/// place in the earlier frame or, when a crack made it in between, from that of the vertex that it was split
/// from, or from its place in the edge or face in which it was born (ancestry()). So nothing jumps at a frame
/// and no face is stretched over a crack: the crack opens from closed to its width in the later frame. What
/// is said about the mesh is the earlier frame's until the later one is reached: the fragments, and the
/// states of edges. Velocities, and strains of hinges that do not break on the way, are interpolated, too;
/// that of a hinge within a face that is split on the way grows from 0. So are the fields of faces; a part of
/// a face begins with those of the whole.
///
/// Throws Error (input) when the frames are not those of one run, in this order.
Snapshot interpolated(const Snapshot& earlier, const Snapshot& later, double share);

/// The pose between two others: `pivot` (m, in the body's own frame) goes straight, the body turns about it
/// at constant speed, the shorter way round. One that is not finite has nothing between: then the earlier
/// one.
Eigen::Isometry3d interpolated(const Eigen::Isometry3d& earlier, const Eigen::Isometry3d& later, double share,
                               const Vector3d& pivot);

}  // namespace sherd
