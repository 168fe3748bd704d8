// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// How quiet steps of a plate grow with its mesh, up to about `most_vertices`, with each choice of a solver
/// that has `only` in its name, beside lower bounds. As paper_figure().
std::pair<Json, std::string> scaling(const std::string& only, double most_vertices, bool print);

}  // namespace sherd
