// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <string_view>

#include "meshops/error.h"
#include "meshops/read_write/material_library.h"
#include "meshops/read_write/obj_name.h"
#include "meshops/read_write/text_line.h"
#include "meshops/soup/polygon_soup.h"

namespace sherd {
namespace {

/// Statements of one kind that the parser skips.
struct Skipped {
    std::size_t count = 0, first_line = 0;
    std::string first_keyword;
};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 4> with_names{"g", "o", "usemtl", "mtllib"};
/// Statements about display, which Sherd ignores.
constexpr std::array<std::string_view, 11> for_display{
    "vn", "s", "mg", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "maplib", "usemap"};
constexpr std::array<std::string_view, 20> of_free_forms{
    "vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf",  "parm",  "trim",
    "hole", "scrv",   "sp",  "end",  "con",  "bzp",  "bsp",   "ctech", "stech", "cdc"};
constexpr const char* free_form_kind = "free-form curves and surfaces";

std::string skipped_kind(std::string_view keyword) {
    if (keyword == "l") return "polylines (`l`)";
    if (keyword == "p") return "points (`p`)";
    return is_one_of(of_free_forms, keyword) ? free_form_kind : "unknown statements";
}

/// Reads an OBJ text line by line.
class ObjParser {
  public:
    ObjParser(const std::filesystem::path& file, std::string_view text) : lines(file, text) {
        soup.file = file;
    }

    PolygonSoup parse() {
        while (!lines.is_at_end()) parse_line(next_line());
        add_later_texture();
        require_faces();
        warn_of_skipped();
        if (!has_texture) soup.texture.clear();
        const auto is_named = [](const GroupNames& names) { return names != nullptr; };
        if (std::ranges::none_of(soup.look.groups, is_named)) soup.look.groups.clear();
        for (auto& [name, material] : materials) material->definition = definitions[name];
        if (materials.empty())
            soup.look.material.clear();
        else
            soup.warnings.insert(soup.warnings.end(), missing_libraries.begin(), missing_libraries.end());
        return std::move(soup);
    }

  private:
    std::string_view next_line() {
        std::string_view line = lines.next_text();
        line_number = lines.number();
        if (!is_continued(line)) return line;
        // A backslash at the end of a line continues it on the next line; a blank replaces the backslash and
        // the line end.
        joined_line.clear();
        do {
            joined_line += line.substr(0, line.rfind('\\'));
            joined_line += ' ';
            line = lines.next_text();
        } while (is_continued(line) && !lines.is_at_end());
        return joined_line += line;
    }

    /// Whether the line's last word ends with a backslash that is not in a comment.
    static bool is_continued(std::string_view line) {
        const std::size_t last = line.find_last_not_of(" \t\r");
        if (last == line.npos || line[last] != '\\') return false;
        return comment_start(line, has_name(line)) == line.npos;
    }

    static bool has_name(std::string_view line) {
        const std::filesystem::path nowhere;
        return is_one_of(with_names, lower_case(TextLine(nowhere, 0, line).next_word()));
    }

    void parse_line(std::string_view line) {
        TextLine words(soup.file, line_number, line.substr(0, comment_start(line, has_name(line))));
        const std::string_view word = words.next_word();
        if (word.empty()) return;
        const std::string keyword = lower_case(word);
        const std::string_view rest = line.substr(static_cast<std::size_t>(word.end() - line.begin()));
        if (keyword == "v") {
            parse_point(words);
        } else if (keyword == "vt") {
            const double u = words.next_number();
            texture_points.emplace_back(u, words.is_at_end() ? 0.0 : words.next_number());
        } else if (keyword == "f" || keyword == "fo") {
            parse_face(words);
        } else if (keyword == "g") {
            groups = names_in(rest);
            std::ranges::transform(groups, groups.begin(), utf8_name);
            face_groups = nullptr;
        } else if (keyword == "o") {
            object = utf8_name(name_in(rest));
            face_groups = nullptr;
        } else if (keyword == "usemtl") {
            use_material(utf8_name(name_in(rest)));
        } else if (keyword == "mtllib") {
            add_libraries(rest);
        } else if (!is_one_of(for_display, keyword)) {
            skip(skipped_kind(keyword), word);
        }
    }

    /// Reads a point. It has three coordinates, perhaps a weight that divides them, and perhaps a colour of
    /// three components.
    void parse_point(TextLine& words) {
        const double x = words.next_number(), y = words.next_number(), z = words.next_number();
        TextLine ahead = words;
        int more = 0;
        while (!ahead.next_word().empty()) ++more;
        const double weight = more == 1 || more == 4 ? words.next_number() : 1;
        if (weight == 0) words.fail("a vertex of weight 0 lies at infinity: leave the weight out", {});
        if (more >= 3) skip("colours of vertices (`v`); save the mesh as PLY to keep them", "v");
        soup.points.emplace_back(x / weight, y / weight, z / weight);
        soup.point_line.push_back(line_number);
    }

    void skip(const std::string& kind, std::string_view keyword) {
        Skipped& now = skipped[kind];
        if (now.count++ > 0) return;
        now.first_line = line_number;
        now.first_keyword = keyword.substr(0, 40);
    }

    void warn_of_skipped() {
        for (const auto& [kind, statements] : skipped)
            soup.warnings.push_back(
                std::to_string(statements.count) + (statements.count == 1 ? " line was" : " lines were") +
                " skipped: " + kind + " (the first: line " + std::to_string(statements.first_line) + ", `" +
                statements.first_keyword + "`)");
    }

    void require_faces() const {
        if (!soup.polygons.empty() || skipped.empty()) return;
        std::string found;
        for (const auto& [kind, statements] : skipped)
            found += (found.empty() ? "" : "; ") + kind + ", the first in line " +
                     std::to_string(statements.first_line);
        throw Error(soup.file.string() + ": the mesh has no faces (`f`), only " + found + ": " +
                    (skipped.contains(free_form_kind)
                         ? "convert free-form surfaces to polygons in the program that made them"
                         : "export polygons from the program that made them"));
    }

    void use_material(const std::string& name) {
        face_material = nullptr;
        if (name.empty()) return;
        std::shared_ptr<SurfaceMaterial>& material = materials[name];
        if (!material) material = std::make_shared<SurfaceMaterial>(SurfaceMaterial{name});
        face_material = material;
    }

    bool is_there(const std::string& name) const {
        std::error_code not_a_name;  // ignored: a long text, for example, cannot be a name
        return std::filesystem::is_regular_file(soup.file.parent_path() / name, not_a_name);
    }

    /// Returns the names of the files in a `mtllib` statement. If the whole text is the name of a file that
    /// exists, which may contain blanks and `#`, this is the only name; if not, each word is a name.
    std::vector<std::string> library_names(std::string_view text) const {
        text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
        text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
        for (const std::string& whole : {std::string(text), name_in(text)})
            if (is_there(whole)) return {whole};
        std::string with_slashes = name_in(text);
        std::ranges::replace(with_slashes, '\\', '/');
        if (is_there(with_slashes)) return {with_slashes};
        return names_in(text);
    }

    void add_libraries(std::string_view text) {
        for (const std::string& name : library_names(text)) {
            if (is_there(name))
                definitions.merge(read_material_library(soup.file.parent_path() / name));
            else
                missing_libraries.push_back("line " + std::to_string(line_number) + ": the material file '" +
                                            name + "' does not exist; its materials have names only");
        }
    }

    /// Returns the groups of a face in the current line; null: none.
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
            if (i >= texture_points.size())
                later_texture.push_back(
                    {soup.polygons.size(), texture.size(), i, line_number, std::string(corner)});
            texture.push_back(i < texture_points.size() ? texture_points[i] : Eigen::Vector2d::Zero());
        }
        // Texture coordinates are useless if some corners have none.
        if (texture.size() != polygon.size()) texture.clear();
        has_texture = has_texture || !texture.empty();
        soup.polygons.push_back(std::move(polygon));
        soup.texture.push_back(std::move(texture));
        soup.polygon_line.push_back(line_number);
        soup.look.groups.push_back(present_groups());
        soup.look.material.push_back(face_material);
    }

    /// Fills in the texture coordinates of corners whose texture points follow the faces in the file. Throws
    /// Error if there is no such texture point.
    void add_later_texture() {
        for (const LaterTexture& later : later_texture) {
            if (later.point >= texture_points.size())
                TextLine(soup.file, later.line, "")
                    .fail("names a texture point that does not exist", later.word);
            auto& texture = soup.texture[later.polygon];
            if (!texture.empty()) texture[later.corner] = texture_points[later.point];
        }
    }

    /// Removes the index at the front of `numbers` and returns it counted from 0. OBJ counts from 1, or
    /// backwards from -1 for the last item read so far; `count` is the number of items read so far. A
    /// positive index may refer to an item that follows. corner: the whole word, for messages.
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

    /// A corner with a texture point that follows in the file: the numbers of polygon, corner and texture
    /// point, and the line and word that name the point.
    struct LaterTexture {
        std::size_t polygon, corner, point, line;
        std::string word;
    };

    PolygonSoup soup;
    std::vector<Eigen::Vector2d> texture_points;
    std::vector<LaterTexture> later_texture;
    std::map<std::string, Skipped> skipped;  ///< skipped statements by kind
    bool has_texture = false;
    std::vector<std::string> groups;  ///< names of the last `g` line
    std::string object;               ///< name of the last `o` line
    GroupNames face_groups;           ///< `groups` and `object`; created when a face needs them
    std::map<std::string, std::shared_ptr<SurfaceMaterial>> materials;  ///< used materials, by name
    std::vector<std::string> missing_libraries;      ///< warnings, given if the mesh uses materials
    std::map<std::string, std::string> definitions;  ///< definitions of materials, by name
    FaceMaterial face_material;                      ///< material of the last `usemtl` line
    TextLines lines;
    std::string joined_line;      ///< text of a line that continues over several lines
    std::size_t line_number = 0;  ///< number of the current line, from 1
};

}  // namespace

PolygonSoup parse_obj(const std::filesystem::path& file, std::string_view text) {
    return ObjParser(file, text).parse();
}

}  // namespace sherd
