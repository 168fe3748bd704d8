// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/variant_remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "meshops/error.h"

namespace sherd {

void VariantRemarks::add(const std::string& variant, const std::string& lines) {
    ++variants;
    std::istringstream stream(lines);
    for (std::string line; std::getline(stream, line);) {
        auto known = std::find_if(remarks.begin(), remarks.end(),
                                  [&](const auto& remark) { return remark.first == line; });
        if (known == remarks.end()) known = remarks.insert(known, {line, {}});
        known->second.push_back(variant);
    }
}

std::vector<std::string> VariantRemarks::lines() const {
    std::vector<std::string> lines;
    for (const auto& [line, who] : remarks)
        lines.push_back(who.size() == variants ? line
                                               : fmt::format("{} (variant {})", line, fmt::join(who, ", ")));
    return lines;
}

void VariantRemarks::throw_if_any() const {
    if (!remarks.empty()) throw Error(fmt::format("{}", fmt::join(lines(), "\n")));
}

}  // namespace sherd
