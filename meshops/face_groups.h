// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// The names of all faces' groups, each once, in alphabetical order; empty if the mesh has none.
std::vector<std::string> group_names(const Mesh& mesh);

/// Whether a face at the vertex belongs to the group.
bool is_in_group(const Mesh& mesh, Vertex vertex, std::string_view group);

/// The names as OBJ's groups have them, one word each: spaces become underscores.
GroupNames one_word_names(const GroupNames& names);

}  // namespace sherd
