// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml_table.h"

namespace sherd {

/// Most faces of a mesh that a scene may ask for; past it a mistyped edge length is more likely than a wish.
inline constexpr double most_faces = 5e6;

/// Faces of an equilateral mesh of `area` (m^2) with edges of `edge_length` (m).
double expected_faces(double area, double edge_length);

/// Reads `mesh = { generate = ... }` and expands plates and bowls to profiles.
GeneratedMesh read_shape(TomlTable& table);

}  // namespace sherd
