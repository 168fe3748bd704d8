// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Fault for which read_mesh() without repair refuses a triangle of a file. If a triangle has several faults,
/// the last one in this list counts.
enum class TriangleFault { none, zero_area, repeated, non_manifold };

/// The triangles of a mesh file without any repair, and their faults.
struct FaultyMesh {
    TriangleSheet sheet;
    std::vector<TriangleFault> faults;  ///< fault of each triangle
};

/// Finds the faults of the triangles of a mesh file. Since a triangle of zero area cannot be seen, its
/// neighbours across edges get its fault, too. join: whether points at exactly the same place are joined
/// first. distance: if positive, points on the boundary within this distance of each other, in units of the
/// file, are joined first. Throws Error, as read_mesh() does, if the file cannot be read at all.
FaultyMesh find_mesh_faults(const std::filesystem::path& file, bool join, double distance = 0);

}  // namespace sherd
