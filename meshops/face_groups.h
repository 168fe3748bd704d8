// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/attributes.h"

namespace sherd {

/// Returns the names of the groups of all faces, each once, in alphabetical order; none if the mesh has no
/// groups.
std::vector<std::string> group_names(const Mesh& mesh);

/// Whether a face at the vertex belongs to the group.
bool is_in_group(const Mesh& mesh, Vertex vertex, std::string_view group);

/// Returns the names with underscores in place of spaces, since the name of a group in OBJ is a single word.
GroupNames one_word_names(const GroupNames& names);

}  // namespace sherd
