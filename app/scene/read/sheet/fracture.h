// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

/// Reads the key `fracture` of a sheet. The sheet's material must have been read before.
void read_fracture(TomlTable& table, const KeyInfo& key, SheetSpec& sheet);
std::vector<SectionText> inside_fracture();

}  // namespace sherd
