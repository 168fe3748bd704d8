// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/toml/toml_table.h"
#include "app/sweep/study.h"

namespace sherd {

/// Reads the parameters of a study's table `parameters`, in the order of the file. Dotted keys are those of
/// the scene. Mistakes are added to the problems.
std::vector<StudyParameter> read_parameters(const toml::table& table, Problems& problems);

}  // namespace sherd
