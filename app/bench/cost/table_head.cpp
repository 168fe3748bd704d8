// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/table_head.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sherd {

std::string table_head(const std::vector<std::string>& columns) {
    const std::vector<std::string> rules(columns.size(), "---");
    return fmt::format("| {} |\n| {} |\n", fmt::join(columns, " | "), fmt::join(rules, " | "));
}

}  // namespace sherd
