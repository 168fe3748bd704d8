// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/build/built_scene.h"

namespace sherd {

/// A line that says how many faces bend as a polynomial, and why others do not; empty with other models.
std::string bending_words(const BuiltScene& built);

}  // namespace sherd
