// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Reads edges of a mesh from a text file, and returns them in the order of the file. Each line has one edge,
/// as the 0-based numbers of its two vertices in the mesh's own file (attribute::file_vertex); empty lines
/// are skipped, and a # starts a comment. Throws Error with file and line on a line that is not two numbers,
/// on two vertices without an edge between them, on an edge on the boundary, and on an edge given before (in
/// either direction); also on a file that is missing or has no edge.
std::vector<Edge> read_edge_list(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace sherd
