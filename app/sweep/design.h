// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/sweep/study.h"

namespace sherd {

/// The points of a study: of each the values of all parameters, as TOML. The same study has the same points
/// on every machine. Of `latin` (McKay, Beckman and Conover 1979) and `random` designs a parameter with a
/// list has its values by equal shares.
std::vector<std::vector<std::string>> design_points(const Study& study);

}  // namespace sherd
