// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/basic_shapes.h"
#include "core/contact/geometry/collider_surface.h"
#include "meshops/mesh.h"
#include "meshops/signed_distance_grid.h"

namespace sherd {

// These are the surfaces of shapes, as triangles that face outward, in the frame of the shape. Round ones
// have their points on the surface and their facets inside it, by about `sagitta` (m), but no fewer of them
// than are good to look at and no more than 37,000.

ColliderSurface facets(const PlaneShape& plane, double sagitta);  ///< empty: it has no corner and no edge
ColliderSurface facets(const SphereShape& sphere, double sagitta);
ColliderSurface facets(const CylinderShape& cylinder, double sagitta);
ColliderSurface facets(const BoxShape& box, double sagitta);
ColliderSurface facets(const Mesh& mesh);
ColliderSurface facets(const GridSurface& surface);

}  // namespace sherd
