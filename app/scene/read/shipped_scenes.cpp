// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/shipped_scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "app/messages/nearest_name.h"
#include "app/scene/toml/toml_file.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr const char* studies = "studies";  // folder of the studies

/// Returns the first sentence of the comment at the head of a file.
std::string description_of(const fs::path& file) {
    std::ifstream stream(file);
    std::string text;
    for (std::string line; std::getline(stream, line) && line.starts_with('#');) {
        line.erase(0, std::min(line.find_first_not_of("# "), line.size()));
        if (!line.empty() && !line.starts_with("SPDX")) text += (text.empty() ? "" : " ") + line;
    }
    return text.substr(0, std::min(text.find(". "), text.size() - text.ends_with('.')));
}

bool is_below(const ShippedScene& scene) {
    return scene.name.find('/') != std::string::npos;
}

const ShippedScene* find_named(std::string name, const std::vector<ShippedScene>& scenes) {
    if (name.ends_with(".toml")) name.erase(name.size() - 5);
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const ShippedScene& scene) { return scene.name == name; });
    return found == scenes.end() ? nullptr : &*found;
}

/// Returns advice on an unknown name: the most similar known name, if there is one, and how to list all.
std::string advice(const std::string& given, const std::vector<ShippedScene>& scenes) {
    std::vector<std::string> names, last_parts;
    for (const ShippedScene& scene : scenes) {
        names.push_back(scene.name);
        last_parts.push_back(scene.file.stem().string());
    }
    std::string nearest = nearest_name(given, names);
    if (nearest.empty()) {
        const std::string part = nearest_name(fs::path(given).stem().string(), last_parts);
        const auto at = std::find(last_parts.begin(), last_parts.end(), part);
        if (at != last_parts.end()) nearest = names[static_cast<std::size_t>(at - last_parts.begin())];
    }
    return nearest.empty() ? "'sherd scenes' lists those that do"
                           : fmt::format("did you mean '{}'? 'sherd scenes' lists them all", nearest);
}

bool is_missing(const fs::path& path) {
    std::error_code unreadable;  // an unreadable file exists; reading it reports the error
    return fs::status(path, unreadable).type() == fs::file_type::not_found;
}

/// Returns the scenes that come with the program; none if their folder is missing.
std::vector<ShippedScene> scenes_if_any() try {
    return shipped_scenes(shipped_scene_folder());
} catch (const Error&) {
    return {};
}

void collect_strings(const toml::node& node, std::set<std::string>& strings) {
    if (const auto* text = node.as_string()) strings.insert(text->get());
    if (const toml::table* table = node.as_table())
        for (const auto& [key, value] : *table) collect_strings(value, strings);
    if (const toml::array* array = node.as_array())
        for (const toml::node& value : *array) collect_strings(value, strings);
}

}  // namespace

fs::path shipped_scene_folder() {
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path() / SHERD_SHARE / "scenes";
    std::error_code missing;
    fs::path found = fs::canonical(folder, missing);
    if (missing)
        throw Error(
            fmt::format("the scenes that come with the program are not in '{}'; install the whole program",
                        folder.lexically_normal().string()),
            Fault::run);
    return found;
}

std::vector<ShippedScene> shipped_scenes(const fs::path& folder) {
    std::vector<ShippedScene> scenes;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const fs::path& file = entry.path();
        const bool is_study = file.parent_path() == folder / studies;
        if (entry.is_regular_file() && file.extension() == ".toml" && !is_study)
            scenes.push_back({fs::path(file).replace_extension().lexically_relative(folder).string(), file,
                              description_of(file)});
    }
    std::ranges::sort(scenes, {}, [](const ShippedScene& scene) {
        return std::pair<bool, std::string_view>(is_below(scene), scene.name);
    });
    return scenes;
}

ShippedScene shipped_scene(const std::string& name, const std::vector<ShippedScene>& scenes) {
    if (const ShippedScene* scene = find_named(name, scenes)) return *scene;
    throw Error(
        fmt::format("no scene of the name '{}' comes with the program; {}", name, advice(name, scenes)));
}

fs::path find_scene(const std::string& given) {
    std::error_code ignored;
    const bool is_folder = fs::is_directory(given, ignored);
    if (!is_missing(given) && !is_folder) return given;
    if (!is_missing(given + ".toml")) return given + ".toml";
    const std::vector<ShippedScene> scenes = scenes_if_any();
    if (const ShippedScene* scene = find_named(given, scenes)) return scene->file;
    if (is_folder) return given;  // reading the folder reports the error
    throw Error(fmt::format(
        "{}: cannot read the scene: there is no such file, and no scene of this name comes with the program; "
        "{}",
        given, advice(given, scenes)));
}

fs::path find_study(const std::string& given) {
    if (!is_missing(given)) return given;
    if (!is_missing(given + ".toml")) return given + ".toml";
    fs::path shipped = shipped_scene_folder() / studies / fs::path(given).filename();
    if (shipped.extension() != ".toml") shipped += ".toml";
    return is_missing(shipped) ? fs::path(given) : shipped;
}

std::vector<fs::path> files_of_scene(const fs::path& scene) {
    std::set<std::string> strings;
    collect_strings(parse_toml(read_toml_text(scene, "scene"), scene), strings);
    std::vector<fs::path> files;
    for (const std::string& text : strings) {
        std::error_code no_file;
        if (fs::is_regular_file(scene.parent_path() / text, no_file)) files.emplace_back(text);
    }
    return files;
}

}  // namespace sherd
