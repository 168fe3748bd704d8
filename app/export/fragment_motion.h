// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// A fragment as a rigid body with the same momenta.
struct FragmentMotion {
    Index faces = 0;
    double mass = 0;                       ///< kg
    Vector3d centre = Vector3d::Zero();    ///< m, centre of mass
    Matrix3d inertia = Matrix3d::Zero();   ///< kg m^2, about the centre, along the axes of space
    Vector3d velocity = Vector3d::Zero();  ///< m/s, of the centre
    Vector3d spin = Vector3d::Zero();      ///< rad/s, from the angular momentum about the centre
};

/// Returns the fragments of a frame in the order of their numbers. As in the momenta of a run, all mass is at
/// the vertices, so that the thickness adds no inertia about the middle surface. The mass of a vertex of
/// several fragments is divided equally among its faces, and so among the fragments. The spin about an axis
/// without inertia is zero.
std::vector<FragmentMotion> fragment_motions(const Snapshot& frame);

}  // namespace sherd
