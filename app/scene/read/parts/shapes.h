// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/mesh_spec.h"

namespace sherd {

/// Reads `mesh = { generate = ... }` and expands plates and bowls to profiles.
void read_shape(TomlTable& table, GeneratedMesh& mesh);
std::vector<SectionText> inside_shapes();

}  // namespace sherd
