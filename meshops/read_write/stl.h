// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Returns the content of a binary STL file with the triangles of the sheet, in their order, and their
/// normals. STL has single precision and no shared vertices: readers join coincident points, also across
/// closed cracks.
std::string stl_bytes(const TriangleSheet& sheet);

}  // namespace sherd
