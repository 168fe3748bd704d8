// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// The volume within a closed mesh and its moments, exact sums over tetrahedra. Where closed components
/// overlap, the overlap counts twice; cavities, whose normals point into them, do not count.
struct SolidMoments {
    double volume = 0;       ///< m^3, negative if the mesh is inside out
    Eigen::Vector3d centre;  ///< m, centre of mass
    Eigen::Matrix3d second;  ///< m^5, the integral of (x - centre)(x - centre)^T

    /// Inertia tensor about the centre per unit of density, m^5.
    Eigen::Matrix3d inertia() const { return second.trace() * Eigen::Matrix3d::Identity() - second; }
};

/// Moments of a closed mesh; those of an open mesh depend on its position.
SolidMoments solid_moments(const Mesh& mesh);

}  // namespace sherd
