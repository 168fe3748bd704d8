// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/sweep/study/study.h"

namespace sherd {

/// Returns the points of a study: for each point the values of all parameters, as TOML, in the order of the
/// parameters. A study has the same points on every machine. In `latin` designs (McKay, Beckman and Conover
/// 1979) and `random` ones, all values in a parameter's list are equally probable.
std::vector<std::vector<std::string>> design_points(const Study& study);

}  // namespace sherd
