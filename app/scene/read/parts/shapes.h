// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/mesh_spec.h"

namespace sherd {

/// Reads `mesh = { generate = ... }`, and computes the profile of a plate or a bowl.
void read_shape(TomlTable& table, GeneratedMesh& mesh);
std::vector<SectionText> inside_shapes();

}  // namespace sherd
