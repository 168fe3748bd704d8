// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

extern const Section<Scene> force_section;  ///< `[force]`: gravity, loads and wind

}  // namespace sherd
