// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns [3, V] m, where the vertices of a sheet start that is flat at rest and is rolled to a cylinder:
/// lines along `along` become arcs and keep their length. Throws Error naming the scene's line and key when
/// the mesh is not flat, or `along` is across it.
Positions bent_start(const BendSpec& bend, const Mesh& placed, const Eigen::Isometry3d& place);

}  // namespace sherd
