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

/// Returns the fragments of a frame in the order of their numbers. As in the run's momenta, masses are those
/// of vertices: without the inertia of the thickness about the middle surface. A vertex of several fragments
/// is shared among them by its faces. About an axis without inertia there is no spin.
std::vector<FragmentMotion> fragment_motions(const Snapshot& frame);

}  // namespace sherd
