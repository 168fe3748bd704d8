// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// Cost of the steps of plate_drop in which something breaks, relative to the others, with each solver choice
/// that has `only` in its name. Result as in paper_figure().
std::pair<Json, std::string> cracking(const std::string& only, bool quick, bool print);

}  // namespace sherd
