// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/sweep/study/study.h"

namespace sherd {

/// Returns the points of a study: for each the values of all parameters, as TOML. A study has the same points
/// on every machine. In `latin` (McKay, Beckman and Conover 1979) and `random` designs the values of a
/// parameter with a list have equal shares.
std::vector<std::vector<std::string>> design_points(const Study& study);

}  // namespace sherd
