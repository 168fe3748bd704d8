// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "meshops/error.h"
#include "meshops/text_line.h"

namespace sherd {
namespace {

double coordinate(TextLine& line) {
    if (line.is_at_end()) line.fail("a coordinate is missing; write x y z, in metres", "");
    const double value = line.next_number();
    if (!std::isfinite(value)) line.fail("a coordinate is not finite", "");
    return value;
}

}  // namespace

std::vector<std::vector<LinePoint>> read_cut_lines(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file))
        throw Error(fmt::format("{}: cannot read the lines to cut; check the path", file.string()));
    std::vector<std::vector<LinePoint>> lines;
    bool is_new = true;
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    TextLines texts(file, without_byte_order_mark(file, content));
    while (!texts.is_at_end()) {
        const std::string_view text = texts.next_text();
        const bool is_comment =
            text.find_first_not_of(" \t\r") == text.find('#') && text.find('#') != text.npos;
        TextLine line(file, texts.number(), text.substr(0, text.find('#')));
        if (line.is_at_end()) {
            is_new = is_new || !is_comment;
            continue;
        }
        const double x = coordinate(line), y = coordinate(line), z = coordinate(line);
        if (!line.is_at_end()) line.fail("is one too many; write x y z, in metres", line.next_word());
        if (is_new) lines.emplace_back();
        is_new = false;
        lines.back().push_back({{x, y, z}, fmt::format("{}:{}", file.string(), texts.number())});
    }
    if (lines.empty()) throw Error(fmt::format("{}: holds no point; write x y z a line", file.string()));
    for (const auto& line : lines)
        if (line.size() < 2)
            throw Error(line.front().name +
                        ": this point stands alone; a line needs two or more, without an empty "
                        "line between them");
    return lines;
}

}  // namespace sherd
