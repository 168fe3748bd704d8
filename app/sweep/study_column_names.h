// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sherd {

/// Whether tables have a column of this name, apart from parameters and keys of Python files.
bool is_study_column(std::string_view name);

}  // namespace sherd
