// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/plain_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd {
namespace {

constexpr std::string_view name_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";

}  // namespace

std::string read_plain_name(TomlTable& table, std::string_view thing, std::string_view reason,
                            const std::vector<std::string>& earlier) {
    std::string name = table.string("name", fmt::format("the name of the {}", thing));
    if (name.find_first_not_of(name_characters) != std::string::npos || name.starts_with('-'))
        table.report("name", fmt::format("{}: write it in letters, digits, _ and -", reason));
    if (std::find(earlier.begin(), earlier.end(), name) != earlier.end() && !name.empty())
        table.report("name", fmt::format("\"{}\" is the name of another {} already", name, thing));
    return name;
}

}  // namespace sherd
