// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/material_axis.h"

namespace sherd {

extern const Section<MaterialAxis> axis_section;

}  // namespace sherd
