// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/option_value.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "app/help/key_reference.h"
#include "app/messages/split.h"

namespace sherd {
namespace {

/// Returns the extension of a name, for example "h5" for "RUN.h5"; empty for a name without extension.
std::string extension_of(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || dot + 1 == name.size()) return "";
    const std::string extension = name.substr(dot + 1);
    const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0; };
    const bool is_extension = std::all_of(extension.begin(), extension.end(), is_part) &&
                              std::isalpha(static_cast<unsigned char>(extension.front())) != 0;
    return is_extension ? extension : "";
}

/// Returns the extensions in the first brackets of a description that begin with an extension: "obj" and
/// "ply" for "Mesh to write (.obj or .ply)".
std::vector<std::string> described_extensions(const std::string& description) {
    const std::size_t begin = description.find("(.");
    if (begin == std::string::npos) return {};
    const std::size_t end = std::min(description.find(')', begin), description.size());
    std::string list = description.substr(begin + 1, end - begin - 1);
    std::replace(list.begin(), list.end(), ',', ' ');
    std::vector<std::string> extensions;
    for (const std::string& word : split(list, ' '))
        if (word.starts_with('.')) extensions.push_back(extension_of(word));
    return extensions;
}

}  // namespace

OptionValue option_value(const CLI::Option& option) {
    using Kind = OptionValue::Kind;
    const std::string text = value_name(option);
    if (text.empty()) return {Kind::none, {}};
    if (text.find('|') != std::string::npos) return {Kind::words, split(text, '|')};
    if (text == "SCENE.toml") return {Kind::scene, {}};
    if (text.starts_with("KEY=VALUE")) return {Kind::setting, {}};
    if (text == "[TABLE]") return {Kind::words, table_names()};
    if (text == "SCENE") return {Kind::shipped_scene, {}};
    if (const std::string extension = extension_of(text); !extension.empty())
        return {Kind::file, {extension}};
    const std::vector<std::string> extensions = described_extensions(option.get_description());
    if (!extensions.empty()) return {Kind::file, extensions};
    const std::vector<std::string_view> files{"PATH", "FILE", "FOLDER", "OUT", "MESH"};
    const bool is_file = std::find(files.begin(), files.end(), text) != files.end();
    return {is_file || option.get_positional() ? Kind::file : Kind::anything, {}};
}

std::vector<std::string> typed_names(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

std::string value_name(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return "";
    if (!option.get_option_text().empty()) return option.get_option_text();
    const std::string type = option.get_type_name();  // CLI11 appends a check, as in INT:POSITIVE
    return type.substr(0, type.find(':'));
}

std::vector<const CLI::Option*> shown_options(const CLI::App& command, bool positional) {
    return command.get_options([positional](const CLI::Option* option) {
        return !option->get_group().empty() && option->get_positional() == positional;
    });
}

std::vector<const CLI::App*> shown_commands(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App* command) {
        return !command->get_name().empty() && !command->get_group().empty();
    });
}

}  // namespace sherd
