// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/bench/shell/shell_case.h"
#include "app/json/json.h"

namespace sherd {

/// Lengths of edges that give the hemisphere with a hole about 400, 1,600 and 6,400 vertices.
inline constexpr std::array<double, 3> hemisphere_edges{0.66, 0.325, 0.162};

/// Cost of an iteration on the hemisphere, relative to the first of the models. Prints a table as it goes, if
/// `print`. Returns an array with an object for each mesh and model.
Json iteration_costs(const std::vector<std::string>& models, const std::vector<double>& edges, bool print);

/// Cost of explicit steps with each model. Arguments and result are as in iteration_costs().
Json explicit_costs(const std::vector<std::string>& models, bool print);

/// For each case, the mesh that each model needs for the error that coupled hinges have on the coarse mesh,
/// and its cost.
Json costs_at_equal_error(const std::vector<ShellCase>& cases, const std::vector<std::string>& models,
                          bool print);

}  // namespace sherd
