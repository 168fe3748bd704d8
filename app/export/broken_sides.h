// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "fracture/snapshot.h"
#include "meshops/write_mesh.h"

namespace sherd {

/// Shades the sides along cracks of a solid flat. With materials it gives them one of their own, `inside`,
/// and texture coordinates in m: u along the side at rest, on from face to face, and v through the thickness,
/// from the lower side to the upper one. The rest has what it had, or no material. body: made by thickened()
/// of the frame's faces; thickness: [F] m.
void finish_broken_sides(const Snapshot& frame, std::span<const double> thickness, bool with_materials,
                         TriangleSheet& body);

}  // namespace sherd
