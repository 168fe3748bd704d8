// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/settings.h"

#include <fmt/format.h>

#include <sstream>

namespace sherd {
namespace {

void add(std::map<std::string, std::string>& settings, const std::string& path, const toml::node& node) {
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, value] : *table)
            add(settings, path.empty() ? std::string(key) : fmt::format("{}.{}", path, key.str()), value);
        return;
    }
    if (const toml::array* array = node.as_array()) {
        std::size_t number = 0;
        for (const toml::node& value : *array) add(settings, fmt::format("{}[{}]", path, number++), value);
        return;
    }
    std::ostringstream text;
    text << toml::node_view<const toml::node>(node);
    settings[path] = text.str();
}

}  // namespace

std::map<std::string, std::string> settings_of(const toml::table& table) {
    std::map<std::string, std::string> settings;
    add(settings, "", table);
    return settings;
}

}  // namespace sherd
