// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "app/json/json.h"

namespace sherd {

/// Measures steps of a plate that neither touches anything nor breaks, on meshes of 400 to about
/// `most_vertices` vertices, with each solver choice that has `only` in its name, and lower bounds of their
/// cost. If `print`, prints tables as it goes. Returns an object with the memory bandwidth and with an object
/// for each mesh and choice, and a figure as SVG. Throws Error if there is no such choice.
std::pair<Json, std::string> scaling(const std::string& only, double most_vertices, bool print);

}  // namespace sherd
