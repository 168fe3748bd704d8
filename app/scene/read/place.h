// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/toml/toml_table.h"
#include "core/motion.h"

namespace sherd {

/// Reads `place = { translate = [x, y, z], rotate = { axis = [x, y, z], degrees = a } }`.
Eigen::Isometry3d read_place(TomlTable& table);

/// Reads a direction, and makes its length one. A direction that is zero is a problem.
Vector3d read_direction(TomlTable& table, std::string_view key, std::optional<Vector3d> fallback = {});

/// Reads `keys` and `motion` of a table, if it has any.
void read_motion(TomlTable& table, Motion& motion);

}  // namespace sherd
