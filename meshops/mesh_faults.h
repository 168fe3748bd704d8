// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshops/write_mesh.h"

namespace sherd {

/// Why read_mesh() refuses a triangle of a file unless it is repaired; of several the last one counts.
enum class TriangleFault { none, zero_area, repeated, non_manifold };

/// The triangles of a mesh file, as they stand there, and what is wrong with them.
struct FaultyMesh {
    TriangleSheet sheet;
    std::vector<TriangleFault> faults;  ///< of each triangle
};

/// A triangle of zero area cannot be seen: its neighbours over an edge have its fault, too. Throws Error like
/// read_mesh() when the file cannot be read at all. join: points at exactly the same place first.
FaultyMesh find_mesh_faults(const std::filesystem::path& file, bool join);

}  // namespace sherd
