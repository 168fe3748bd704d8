// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/material_library.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include "meshops/error.h"
#include "meshops/read_write/obj_name.h"
#include "meshops/read_write/text_line.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr const char* blank = " \t\r";

/// Removes the first word of `line`, and the blanks around it. Returns the word.
std::string_view take_word(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
    const std::string_view word = line.substr(0, line.find_first_of(blank));
    line.remove_prefix(word.size());
    line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
    return word;
}

std::string_view without_blanks_at_end(std::string_view line) {
    return line.substr(0, line.find_last_not_of(blank) + 1);
}

bool is_number(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return !word.empty() && error == std::errc() && end == word.data() + word.size();
}

bool names_picture(std::string_view word) {
    const std::string keyword = lower_case(word);
    return keyword.starts_with("map_") || keyword == "bump" || keyword == "disp" || keyword == "decal" ||
           keyword == "norm" || keyword == "refl";
}

/// Returns the name of a picture, which is the rest of the arguments of its line behind the options. Each of
/// the options `-o`, `-s` and `-t` has up to three numbers, `-mm` has two, and any other option has one
/// value.
std::string_view picture_name(std::string_view arguments) {
    while (arguments.starts_with('-')) {
        const std::string_view option = take_word(arguments);
        const bool is_vector = option == "-o" || option == "-s" || option == "-t";
        const int most = is_vector ? 3 : option == "-mm" ? 2 : 1;
        for (int i = 0; i < most; ++i) {
            std::string_view rest = arguments;
            const std::string_view value = take_word(rest);
            if (is_vector && !is_number(value)) break;
            arguments = rest;
        }
    }
    const bool is_quoted = arguments.size() > 1 && arguments.starts_with('"') && arguments.ends_with('"');
    return is_quoted ? arguments.substr(1, arguments.size() - 2) : arguments;
}

template <class Visit>
void visit_lines(const std::string& text, Visit visit) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) visit(without_blanks_at_end(line));
}

std::string absolute_name(const fs::path& folder, std::string name) {
    std::ranges::replace(name, '\\', '/');
    return fs::absolute(folder / name).lexically_normal().string();
}

}  // namespace

std::map<std::string, std::string> read_material_library(const fs::path& file) {
    std::ifstream stream(file);
    if (!stream || fs::is_directory(file))
        throw Error(file.string() + ": the material file cannot be read; check its permissions");
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    std::map<std::string, std::string> definitions;
    std::string* current = nullptr;
    TextLines lines(file, without_byte_order_mark(file, content));
    while (!lines.is_at_end()) {
        std::string_view words = without_blanks_at_end(lines.next_text());
        const std::string_view whole = words, keyword = take_word(words);
        if (keyword.empty() || keyword.starts_with('#')) continue;
        if (lower_case(keyword) != "newmtl") {
            if (current) current->append(whole).append("\n");
            continue;
        }
        const std::string name = utf8_name(name_in(words));
        if (name.empty())
            throw Error(file.string() + ":" + std::to_string(lines.number()) + ": newmtl has no name");
        current = &definitions[name];
        current->clear();
    }
    const auto absolute = [&](const std::string& name) { return absolute_name(file.parent_path(), name); };
    for (auto& [name, definition] : definitions) definition = with_pictures(definition, absolute);
    return definitions;
}

std::string with_pictures(const std::string& definition,
                          const std::function<std::string(const std::string&)>& renamed) {
    std::string result;
    visit_lines(definition, [&](std::string_view line) {
        std::string_view arguments = line;
        const bool is_picture = names_picture(take_word(arguments));
        const std::string_view name = is_picture ? picture_name(arguments) : std::string_view();
        // Options stay; quotes around a name are dropped.
        const bool is_quoted = !name.empty() && name.data() + name.size() < line.data() + line.size();
        result.append(line.substr(0, line.size() - name.size() - (is_quoted ? 2 : 0)));
        if (!name.empty()) result += renamed(std::string(name));
        result += '\n';
    });
    return result;
}

std::string statement(const SurfaceMaterial& material, const std::string& keyword) {
    std::string found;
    visit_lines(material.definition, [&](std::string_view line) {
        if (found.empty() && lower_case(take_word(line)) == lower_case(keyword))
            found = names_picture(keyword) ? picture_name(line) : line;
    });
    return found;
}

fs::path material_file(const fs::path& obj) {
    return fs::path(obj).replace_extension(".mtl");
}

std::string material_name(const FaceMaterial& material) {
    return material ? material->name : "none";
}

std::string material_text(const std::vector<FaceMaterial>& materials, const fs::path& obj) {
    const fs::path folder = fs::absolute(obj).lexically_normal().parent_path();
    const auto relative = [&](const std::string& name) {
        return fs::path(name).lexically_proximate(folder).string();
    };
    std::string text;
    std::set<std::string> written;
    for (const FaceMaterial& material : materials) {
        if (!written.insert(material_name(material)).second) continue;
        text += (text.empty() ? "newmtl " : "\nnewmtl ") + writable_name(material_name(material)) + "\n";
        text += material ? with_pictures(material->definition, relative) : "Kd 0.8 0.8 0.8\n";
    }
    return text;
}

}  // namespace sherd
