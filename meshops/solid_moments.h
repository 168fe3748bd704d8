// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// The volume within a closed mesh and its moments, exact sums over tetrahedra. Where closed components
/// overlap, what is in both counts twice; cavities, whose normals point into them, do not count.
struct SolidMoments {
    double volume = 0;       ///< m^3, negative if the mesh is inside out
    Eigen::Vector3d centre;  ///< m, of mass
    Eigen::Matrix3d second;  ///< m^5, the integral of (x - centre)(x - centre)^T

    /// m^5, about the centre, for each unit of density.
    Eigen::Matrix3d inertia() const { return second.trace() * Eigen::Matrix3d::Identity() - second; }
};

/// Of a mesh that is open the moments depend on where it lies.
SolidMoments solid_moments(const Mesh& mesh);

}  // namespace sherd
