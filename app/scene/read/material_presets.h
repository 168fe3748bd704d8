// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "core/material/material.h"

namespace sherd {

/// A material by name, with the thickness of a common sheet of it.
struct MaterialPreset {
    std::string_view name;
    Material material;
};

/// Returns presets of real materials; scenes/README.md gives the source of each.
std::span<const MaterialPreset> material_presets();

}  // namespace sherd
