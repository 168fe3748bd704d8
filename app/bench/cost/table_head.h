// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// The first two lines of a table of Markdown with these columns.
std::string table_head(const std::vector<std::string>& columns);

}  // namespace sherd
