// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/bench/shell/shell_case.h"
#include "app/json/json.h"

namespace sherd {

/// Lengths of edges of meshes of the hemisphere with a hole with about 400, 1,600 and 6,400 vertices.
inline constexpr std::array<double, 3> hemisphere_edges{0.66, 0.325, 0.162};

/// Measures an iteration of Newton's method on the hemisphere with a hole, with each model (shell_variant())
/// on a mesh of each length of edges. If `print`, prints the costs as they are measured, with their ratios to
/// those of the first model. Returns an array with an object for each mesh and model.
Json iteration_costs(const std::vector<std::string>& models, const std::vector<double>& edges, bool print);

/// Measures explicit steps of a struck disc with each model (shell_variant()). If `print`, prints the costs
/// as they are measured. Returns an array with an object for each model.
Json explicit_costs(const std::vector<std::string>& models, bool print);

/// Finds, for each case and each model but `coupled`, the coarsest mesh on which the errors of the model do
/// not exceed the largest error of coupled hinges on the coarse mesh. If `print`, prints each mesh and its
/// processor time as it is found. Returns an array with an object for each case and model.
Json costs_at_equal_error(const std::vector<ShellCase>& cases, const std::vector<std::string>& models,
                          bool print);

}  // namespace sherd
