// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/problems.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/toml/override.h"
#include "meshops/error.h"

namespace sherd {

std::string place_of(const toml::source_region& source) {
    const std::string path = source.path ? *source.path : "scene";
    return is_override(path) ? path : fmt::format("{}:{}", path, source.begin.line);
}

void Problems::add(const toml::source_region& source, std::string_view key, const std::string& what) {
    const bool overridden = source.path && is_override(*source.path);
    problems.push_back({overridden, source.begin, fmt::format("{}: {}: {}", place_of(source), key, what)});
}

void Problems::throw_if_any() const {
    if (problems.empty()) return;
    std::vector<Problem> sorted = problems;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
        return a.overridden != b.overridden ? b.overridden : a.position < b.position;
    });
    std::vector<std::string> lines;
    for (const Problem& problem : sorted) lines.push_back(problem.line);
    throw Error(fmt::format("{}", fmt::join(lines, "\n")));
}

}  // namespace sherd
