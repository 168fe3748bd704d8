// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

extern const Section<SheetSpec> sheet_section;  ///< `[sheet.NAME]`

}  // namespace sherd
