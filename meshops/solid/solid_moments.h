// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Volume within a closed mesh, and its first and second moments, as exact sums over tetrahedra. The overlap
/// of two closed components counts twice; a cavity, whose normals point into it, does not count.
struct SolidMoments {
    double volume = 0;       ///< m^3, negative if the mesh is inside out
    Eigen::Vector3d centre;  ///< m, centre of mass
    Eigen::Matrix3d second;  ///< m^5, integral of (x - centre)(x - centre)^T over the volume

    /// Inertia tensor about the centre per unit of density, m^5.
    Eigen::Matrix3d inertia() const { return second.trace() * Eigen::Matrix3d::Identity() - second; }
};

/// Returns the moments of the volume within `mesh`, which must be closed.
SolidMoments solid_moments(const Mesh& mesh);

}  // namespace sherd
