// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/basic_shapes.h"
#include "core/contact/geometry/collider_surface.h"
#include "meshops/level_set/signed_distance_grid.h"
#include "meshops/mesh.h"

namespace sherd {

// Surfaces of shapes, as triangles that face outward, in the frame of the shape. Points of round shapes lie
// on the surface and facets inside it, by about `sagitta` (m); there are enough facets for pictures, and at
// most 37,000.

ColliderSurface facets(const PlaneShape& plane, double sagitta);  ///< empty: without corner or edge
ColliderSurface facets(const SphereShape& sphere, double sagitta);
ColliderSurface facets(const CylinderShape& cylinder, double sagitta);
ColliderSurface facets(const BoxShape& box, double sagitta);
ColliderSurface facets(const Mesh& mesh);
ColliderSurface facets(const GridSurface& surface);

}  // namespace sherd
