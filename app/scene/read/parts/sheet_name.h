// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reports the key `sheet` of a load, wind or gauge if it names a sheet that the scene does not have.
void check_sheet_name(TomlTable& table, const Scene& scene);

}  // namespace sherd
