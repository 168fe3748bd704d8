// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/json/json.h"

namespace sherd {

/// Computes the cases with `only` in their names on three meshes of three lengths of edges; quickly: on one
/// of the two larger lengths. Prints tables as it goes, if `print`. Returns an object for each run. Throws
/// Error when there is no such case.
Json fracture_experiments(const std::string& only, bool quick, bool print);

}  // namespace sherd
