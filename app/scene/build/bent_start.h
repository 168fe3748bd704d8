// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the start positions, [3, V] m, of a sheet that is flat at rest and is rolled to a cylinder: lines
/// along bend.along become arcs of the same length. Throws Error naming the scene's line and key if the mesh
/// is not flat, or bend.along is normal to it.
Positions bent_start(const BendSpec& bend, const Mesh& placed, const Eigen::Isometry3d& place);

}  // namespace sherd
