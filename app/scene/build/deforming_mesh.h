// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/obstacle_spec.h"
#include "core/contact/geometry/collider_surface.h"
#include "core/deformation.h"

namespace sherd {

/// A mesh whose points a cache moves.
struct DeformingMesh {
    ColliderSurface surface;  ///< as in the first sample
    Deformation deformation;
};

/// Reads the mesh of an obstacle as it is in its file, and its cache. Points that no face uses are left out.
/// Throws Error naming the file: what reading either of them throws, or when their points are not the same
/// ones, or edges have no length in the first sample; warnings begin with the file.
DeformingMesh make_deforming_mesh(const ObstacleMesh& spec, std::vector<std::string>& warnings);

/// Warns where a cache is over before the scene is, or hardly begun at its end.
void warn_of_cache(const ObstacleSpec& spec, const Deformation& deformation, double duration,
                   std::vector<std::string>& warnings);

}  // namespace sherd
