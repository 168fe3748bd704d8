// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// The first two lines of a Markdown table: the names of the columns, and the rule below them.
std::string table_head(const std::vector<std::string>& columns);

}  // namespace sherd
