// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// The content of a binary STL file of the sheet's triangles, in their order, with their normals. STL has
/// single precision and no shared vertices: readers join coincident points, also across closed cracks.
std::string stl_bytes(const TriangleSheet& sheet);

}  // namespace sherd
