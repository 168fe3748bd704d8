// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Names of the groups that a face is in, shared by all faces that stand together in the file; null: in none.
using GroupNames = std::shared_ptr<const std::vector<std::string>>;

namespace property {
inline constexpr const char* groups = "f:groups";  ///< GroupNames of each face
}  // namespace property

/// The groups of all faces, each once, in alphabetical order; empty when the mesh has none.
std::vector<std::string> group_names(const Mesh& mesh);

/// Whether a face at the vertex is in the group.
bool is_in_group(const Mesh& mesh, Vertex vertex, std::string_view group);

}  // namespace sherd
