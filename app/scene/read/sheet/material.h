// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/read/sheet/material_presets.h"
#include "app/scene/scene.h"

namespace sherd {

/// `material` of a sheet: its material constants, thickness, axis and preset.
extern const Section<SheetSpec> material_section;

}  // namespace sherd
