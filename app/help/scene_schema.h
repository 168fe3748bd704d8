// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/json/json.h"

namespace sherd {

/// Returns the JSON Schema (2020-12) of scenes, with which editors for TOML complete and check scenes.
Json scene_schema();

}  // namespace sherd
