// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/yielding.h"

namespace sherd {

/// "1.8 times the yield stress, in sheet.lid at (0.1, 0.02, 0) m at rest".
std::string yield_words(double ratio, const YieldPlace& place, const Scene& scene);

}  // namespace sherd
