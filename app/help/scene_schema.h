// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/json/json.h"

namespace sherd {

/// The JSON Schema (2020-12) of scenes, by which editors of TOML complete and check them.
Json scene_schema();

}  // namespace sherd
