// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// Does the experiment of the paper's figure 2 in the scenes with `only` in their names. Prints tables as it
/// goes, if `print`. most_vertices: of the largest mesh. Returns an object for each case and choice, and the
/// figure, as SVG. Throws Error when there is no such scene.
std::pair<Json, std::string> paper_figure(const std::string& only, bool quick, double most_vertices,
                                          bool print);

}  // namespace sherd
