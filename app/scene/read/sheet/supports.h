// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/scene.h"

namespace sherd {

extern const Section<PinSpec> pin_section, clamp_section;
extern const Section<SymmetrySpec> symmetry_section;

}  // namespace sherd
