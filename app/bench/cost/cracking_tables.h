// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// What steps of plate_drop cost in which something breaks, beside those in which nothing does, with each
/// choice of a solver that has `only` in its name. As paper_figure().
std::pair<Json, std::string> cracking(const std::string& only, bool quick, bool print);

}  // namespace sherd
