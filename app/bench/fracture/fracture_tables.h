// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/json/json.h"

namespace sherd {

/// Simulates the cases with `only` in their names on three meshes for each of three lengths of edges or, if
/// `quick`, on one mesh for each of the two largest lengths. If `print`, prints tables as it goes. Returns an
/// array with an object for each run. Throws Error if there is no such case.
Json fracture_experiments(const std::string& only, bool quick, bool print);

}  // namespace sherd
