// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// Repeats the experiment of figure 2 of the paper Cubic Shells in the scenes with `only` in their names:
/// each scene is simulated with several sizes of steps and meshes of at most `most_vertices` vertices
/// (PaperCase), by each solver choice (SolverChoice). If `quick`, there are fewer sizes and coarser meshes.
/// If `print`, prints tables as it goes. Returns an array with an object for each case and choice, and the
/// figure as SVG. Throws Error if there is no such scene.
std::pair<Json, std::string> paper_figure(const std::string& only, bool quick, double most_vertices,
                                          bool print);

}  // namespace sherd
