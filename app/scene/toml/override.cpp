// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/override.h"

#include <fmt/format.h>

#include <optional>

#include "meshops/error.h"

namespace sherd {
namespace {

constexpr std::string_view option = "--set ";
constexpr std::string_view advice = "write KEY=VALUE, for example --set solver.step=1e-4";

std::optional<toml::table> parse(const std::string& text, const std::string& source) {
    try {
        return toml::parse(text, source);
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

/// Parses an assignment. A string may lack the quotes of TOML, since shells remove them.
toml::table parse_assignment(const std::string& assignment) {
    const std::string source = std::string(option) + assignment;
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || assignment.find('\n') != std::string::npos)
        throw Error(fmt::format("{}: is not an assignment on one line; {}", source, advice));
    const std::string key = assignment.substr(0, equals), value = assignment.substr(equals + 1);
    if (auto table = parse(assignment, source)) return std::move(*table);
    if (!parse(key + " = 0", source))
        throw Error(fmt::format("{}: '{}' is not a dotted key; {}", source, key, advice));
    const bool bare = value.find_first_of("[]{}\"'\\#") == std::string::npos &&
                      value.find_first_not_of(" \t") != std::string::npos;
    if (bare)
        if (auto table = parse(fmt::format("{} = \"{}\"", key, value), source)) return std::move(*table);
    throw Error(fmt::format("{}: '{}' is not a TOML value; {}", source, value, advice));
}

}  // namespace

void merge_keys(toml::table& into, toml::table&& from) {
    for (auto&& [key, node] : from) {
        toml::node* present = into.get(key.str());
        toml::table* added = node.as_table();
        if (added && !added->is_inline() && present && present->is_table()) {
            merge_keys(*present->as_table(), std::move(*added));
            continue;
        }
        into.erase(key.str());
        node.visit([&into, &name = key](auto& value) { into.insert_or_assign(name, std::move(value)); });
    }
}

void apply_override(toml::table& scene, const std::string& assignment) {
    merge_keys(scene, parse_assignment(assignment));
}

bool is_override(std::string_view source_path) {
    return source_path.starts_with(option);
}

}  // namespace sherd
