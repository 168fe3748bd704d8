// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/basic_shapes.h"
#include "core/contact/geometry/collider_surface.h"
#include "meshops/level_set/signed_distance_grid.h"
#include "meshops/mesh.h"

namespace sherd {

// facets() returns the surface of a shape as triangles whose normals point outward, in the shape's frame.
// Corners of triangles lie on the surface, and for a round shape the triangles lie inside it, by at most
// about `sagitta` (m). A round shape has enough triangles for pictures, and at most 37,000.

ColliderSurface facets(const PlaneShape& plane, double sagitta);  ///< returns an empty surface, as a plane
                                                                  ///< has no corner or edge
ColliderSurface facets(const SphereShape& sphere, double sagitta);
ColliderSurface facets(const CylinderShape& cylinder, double sagitta);
ColliderSurface facets(const BoxShape& box, double sagitta);
ColliderSurface facets(const Mesh& mesh);
ColliderSurface facets(const GridSurface& surface);

}  // namespace sherd
