// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cstdint>
#include <map>
#include <string_view>

#include "meshops/material_library.h"
#include "meshops/polygon_soup.h"
#include "meshops/text_line.h"

namespace sherd {
namespace {

/// Reads an OBJ text line by line.
class ObjParser {
  public:
    ObjParser(const std::filesystem::path& file, std::string_view text) : text(text) { soup.file = file; }

    PolygonSoup parse() {
        while (!text.empty()) parse_line(next_line());
        if (!has_texture) soup.texture.clear();
        for (auto& [name, material] : materials) material->definition = definitions[name];
        if (materials.empty()) soup.material.clear();
        return std::move(soup);
    }

  private:
    std::string_view next_line() {
        line_number += lines_taken;
        lines_taken = 1;
        std::size_t end = text.find('\n');
        // A backslash continues a line: the pieces are joined without it and the line's end.
        joined_line.clear();
        while (end != std::string_view::npos && is_continued(text.substr(0, end))) {
            joined_line += text.substr(0, text.find_last_of('\\', end));
            joined_line += ' ';
            text.remove_prefix(end + 1);
            end = text.find('\n');
            ++lines_taken;
        }
        const std::string_view last = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (joined_line.empty()) return last;
        return joined_line += last;
    }

    static bool is_continued(std::string_view line) {
        if (line.ends_with('\r')) line.remove_suffix(1);
        return line.ends_with('\\');
    }

    void parse_line(std::string_view line) {
        TextLine words(soup.file, line_number, line.substr(0, line.find('#')));
        const std::string_view keyword = words.next_word();
        if (keyword == "v") {
            const double x = words.next_number(), y = words.next_number(), z = words.next_number();
            soup.points.emplace_back(x, y, z);
            soup.point_line.push_back(line_number);
        } else if (keyword == "vt") {
            const double u = words.next_number();
            texture_points.emplace_back(u, words.is_at_end() ? 0.0 : words.next_number());
        } else if (keyword == "f") {
            parse_face(words);
        } else if (keyword == "g") {
            groups = rest_of(words);
            face_groups = nullptr;
        } else if (keyword == "o") {
            object = joined(rest_of(words));
            face_groups = nullptr;
        } else if (keyword == "usemtl") {
            use_material(joined(rest_of(words)));
        } else if (keyword == "mtllib") {
            add_libraries(rest_of(words));
        }
    }

    static std::vector<std::string> rest_of(TextLine& words) {
        std::vector<std::string> rest;
        for (auto word = words.next_word(); !word.empty(); word = words.next_word()) rest.emplace_back(word);
        return rest;
    }

    static std::string joined(const std::vector<std::string>& words) {
        std::string line;
        for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
        return line;
    }

    void use_material(const std::string& name) {
        face_material = nullptr;
        if (name.empty()) return;
        std::shared_ptr<SurfaceMaterial>& material = materials[name];
        if (!material) material = std::make_shared<SurfaceMaterial>(SurfaceMaterial{name});
        face_material = material;
    }

    /// The words are files, or one whose name has spaces.
    void add_libraries(const std::vector<std::string>& words) {
        const std::filesystem::path folder = soup.file.parent_path();
        const std::string line = joined(words);
        const auto is_there = [&](const std::string& name) {
            std::error_code not_a_name;  // of a file, such as one that is too long
            return std::filesystem::exists(folder / name, not_a_name);
        };
        const bool is_one = is_there(line);
        for (const std::string& name : is_one ? std::vector{line} : words) {
            if (is_there(name))
                definitions.merge(read_material_library(folder / name));
            else
                soup.warnings.push_back("line " + std::to_string(line_number) + ": the file of materials '" +
                                        name + "' is not there; they have names only");
        }
    }

    /// The groups of a face at the current line.
    GroupNames present_groups() {
        if (groups.empty() && object.empty()) return nullptr;
        if (!face_groups) {
            std::vector<std::string> names = groups;
            if (!object.empty()) names.push_back(object);
            face_groups = std::make_shared<const std::vector<std::string>>(std::move(names));
        }
        return face_groups;
    }

    void parse_face(TextLine& words) {
        std::vector<std::size_t> polygon;
        std::vector<Eigen::Vector2d> texture;
        for (auto corner = words.next_word(); !corner.empty(); corner = words.next_word()) {
            std::string_view numbers = corner;
            polygon.push_back(index(words, numbers, corner, soup.points.size()));
            if (!numbers.starts_with('/')) continue;
            numbers.remove_prefix(1);
            if (numbers.empty() || numbers.starts_with('/')) continue;
            const std::size_t i = index(words, numbers, corner, texture_points.size());
            if (i >= texture_points.size()) words.fail("names a texture point that is not there", corner);
            texture.push_back(texture_points[i]);
        }
        // Texture coordinates at some corners only are useless.
        if (texture.size() != polygon.size()) texture.clear();
        has_texture = has_texture || !texture.empty();
        soup.polygons.push_back(std::move(polygon));
        soup.texture.push_back(std::move(texture));
        soup.polygon_line.push_back(line_number);
        soup.groups.push_back(present_groups());
        soup.material.push_back(face_material);
    }

    /// The 0-based index at the front of `numbers`, which is advanced. OBJ counts from 1, and backwards from
    /// -1 at the last item so far (of `count`). A positive index may refer to a later item.
    static std::size_t index(const TextLine& words, std::string_view& numbers, std::string_view corner,
                             std::size_t count) {
        std::int64_t value = 0;
        const auto [end, failure] = std::from_chars(numbers.data(), numbers.data() + numbers.size(), value);
        if (failure != std::errc()) words.fail("is not a vertex number", corner);
        numbers.remove_prefix(static_cast<std::size_t>(end - numbers.data()));
        if (!numbers.empty() && numbers.front() != '/') words.fail("is not a vertex number", corner);
        const auto available = static_cast<std::int64_t>(count);
        if (value == 0 || value < -available) {
            words.fail("index out of range: OBJ counts from 1, or from -1 backwards, and " +
                           std::to_string(count) + " were read so far",
                       corner);
        }
        return static_cast<std::size_t>(value > 0 ? value - 1 : available + value);
    }

    PolygonSoup soup;
    std::vector<Eigen::Vector2d> texture_points;
    bool has_texture = false;
    std::vector<std::string> groups;  ///< names of the last `g` line
    std::string object;               ///< name of the last `o` line
    GroupNames face_groups;           ///< groups and object; created when a face needs them
    std::map<std::string, std::shared_ptr<SurfaceMaterial>> materials;  ///< by name, that are used
    std::map<std::string, std::string> definitions;                     ///< of those of the libraries
    FaceMaterial face_material;                                         ///< of the last `usemtl` line
    std::string_view text;                                              ///< the text not read yet
    std::string joined_line;      ///< holds a line that continues over several
    std::size_t line_number = 1;  ///< of the current line, from 1
    std::size_t lines_taken = 0;  ///< number of lines of the text that the current line consists of
};

}  // namespace

PolygonSoup parse_obj(const std::filesystem::path& file, std::string_view text) {
    return ObjParser(file, text).parse();
}

}  // namespace sherd
