// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// A copy of vertices, edges and faces in their order, without properties and without gaps in the numbers.
/// Throws Error (run) on faces that do not fit to each other.
Mesh plain_copy(const Mesh& mesh);

}  // namespace sherd
