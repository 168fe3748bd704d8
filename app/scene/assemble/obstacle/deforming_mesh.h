// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/obstacle_spec.h"
#include "core/contact/geometry/collider_surface.h"
#include "core/deformation.h"

namespace sherd {

/// A mesh that deforms by a point cache.
struct DeformingMesh {
    ColliderSurface surface;  ///< surface in the first sample
    Deformation deformation;
};

/// Reads the mesh of an obstacle, without repairs, and its cache. Points that no face uses are left out.
/// Throws Error naming the file if the mesh or the cache cannot be read, if their numbers of points differ,
/// or if an edge has no length in the first sample. Adds a warning if the mesh has an implausible size.
DeformingMesh make_deforming_mesh(const ObstacleMesh& spec, std::vector<std::string>& warnings);

/// Adds a warning if an obstacle's cache ends before the scene does, or if the scene covers only a small part
/// of the cache. duration: s, of the scene.
void warn_of_cache(const ObstacleSpec& spec, const Deformation& deformation, double duration,
                   std::vector<std::string>& warnings);

}  // namespace sherd
