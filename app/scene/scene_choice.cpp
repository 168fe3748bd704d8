// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace sherd {
namespace {

constexpr std::string_view variant_mark = "# --variant ", override_mark = "# --set ";

}  // namespace

std::string recorded_text(std::string text, const SceneChoice& choice) {
    const auto add = [&text](std::string_view mark, const std::string& chosen) {
        if (!text.ends_with('\n')) text += '\n';
        text += fmt::format("{}{}\n", mark, chosen);
    };
    if (!choice.variant.empty()) add(variant_mark, choice.variant);
    for (const std::string& assignment : choice.overrides) add(override_mark, assignment);
    return text;
}

SceneChoice recorded_choice(const std::string& text) {
    SceneChoice choice;
    std::size_t end = text.size();
    while (end > 0 && text[end - 1] == '\n' && choice.variant.empty()) {
        const std::size_t before = end < 2 ? std::string::npos : text.rfind('\n', end - 2);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        const std::string line = text.substr(begin, end - 1 - begin);
        if (line.starts_with(override_mark))
            choice.overrides.push_back(line.substr(override_mark.size()));
        else if (line.starts_with(variant_mark))
            choice.variant = line.substr(variant_mark.size());
        else
            break;
        end = begin;
    }
    std::reverse(choice.overrides.begin(), choice.overrides.end());
    return choice;
}

}  // namespace sherd
