// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "fracture/snapshot.h"
#include "meshops/write_mesh.h"

namespace sherd {

/// Shades the sides of a solid along cracks flat. With materials, gives these sides their own material,
/// `inside`, and texture coordinates in m: u along the side at rest, continuous from face to face, and v
/// through the thickness, from the lower side to the upper one. Other triangles keep theirs, or have no
/// material. body: result of thickened() for the frame's faces; thickness: [F] m.
void finish_broken_sides(const Snapshot& frame, std::span<const double> thickness, bool with_materials,
                         TriangleSheet& body);

}  // namespace sherd
