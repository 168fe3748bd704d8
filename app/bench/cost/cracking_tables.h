// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// Measures the steps of the scene plate_drop in which something breaks, and its other steps, with each
/// solver choice that has `only` in its name: 5 ms on two meshes or, if `quick`, 3 ms on the coarser one. If
/// `print`, prints a table. Returns an array with an object for each mesh and choice, and a figure as SVG.
/// Throws Error if there is no such choice.
std::pair<Json, std::string> cracking(const std::string& only, bool quick, bool print);

}  // namespace sherd
