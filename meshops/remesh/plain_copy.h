// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// Returns a copy of the vertices and faces in their order, without properties and without gaps in the
/// numbers. Edges may get other numbers. Throws Error (run) on faces that do not fit each other.
Mesh plain_copy(const Mesh& mesh);

}  // namespace sherd
