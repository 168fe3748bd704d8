// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_line.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd {
namespace {

constexpr std::size_t longest_bar = 24, shortest_bar = 10;

bool begins_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) != 0x80;  // in UTF-8
}

std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, begins_character));
}

/// Returns the text, cut off after `columns` characters.
std::string cut(const std::string& text, std::size_t columns) {
    std::size_t seen = 0, end = 0;
    for (; end < text.size(); ++end)
        if (begins_character(text[end]) && ++seen > columns) break;
    return text.substr(0, end);
}

std::string filled_name(const std::string& name, std::size_t columns, std::size_t limit) {
    if (name.empty()) return "";
    const std::size_t room = std::min(std::max(columns, width(name)), limit / 3);
    std::string text = width(name) <= room ? name : cut(name, room - std::min<std::size_t>(room, 1)) + "~";
    text.append(room - std::min(room, width(text)), ' ');
    return text + " ";
}

std::string joined(const std::vector<ProgressPart>& parts) {
    std::string text;
    for (const ProgressPart& part : parts) text += (text.empty() ? "" : "  ") + part.text;
    return text;
}

}  // namespace

std::string progress_line(const ProgressStatus& status, std::size_t columns, std::size_t name_columns) {
    const std::size_t limit = columns - std::min<std::size_t>(columns, 1);
    const std::string name = filled_name(status.name, name_columns, limit);
    std::vector<ProgressPart> parts = status.parts;
    const auto taken = [&] { return width(name) + width(joined(parts)) + 3; };
    while (taken() + shortest_bar > limit && !parts.empty())
        parts.erase(std::ranges::max_element(parts, {}, &ProgressPart::rank));
    const std::size_t bar = std::min(longest_bar, limit - std::min(limit, taken()));
    const auto filled = static_cast<std::size_t>(status.done * static_cast<double>(bar) + 1e-9);
    return cut(fmt::format("{}[{:#>{}}{:.>{}}] {}", name, "", filled, "", bar - filled, joined(parts)),
               limit);
}

std::string progress_record(const ProgressStatus& status) {
    return fmt::format("{}{}{:3}%  {}", status.name, status.name.empty() ? "" : ": ",
                       static_cast<int>(status.done * 100 + 1e-6), joined(status.parts));
}

std::string clock_text(double seconds) {
    constexpr double longest = 999 * 3600.;
    const long whole = static_cast<long>(std::clamp(seconds, 0., longest) + 0.5);
    return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace sherd
