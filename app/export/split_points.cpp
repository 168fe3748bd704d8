// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/split_points.h"

#include <map>
#include <numeric>
#include <tuple>

namespace sherd {

SplitPoints split_points(const TriangleSheet& sheet) {
    SplitPoints split;
    split.points.resize(sheet.points.size());
    std::iota(split.points.begin(), split.points.end(), std::size_t{0});
    split.triangles = sheet.triangles;
    if (sheet.texture.empty()) return split;
    split.texture.assign(sheet.points.size(), Eigen::Vector2d::Zero());
    std::vector<bool> met(sheet.points.size(), false);
    std::map<std::tuple<std::int32_t, double, double>, std::int32_t> number;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            std::int32_t& point = split.triangles[t][k];
            const Eigen::Vector2d& uv = sheet.texture[t][k];
            const bool is_first = !met[point];
            const auto next = static_cast<std::int32_t>(split.points.size());
            const auto [entry, is_new] = number.try_emplace({point, uv.x(), uv.y()}, is_first ? point : next);
            met[point] = true;
            if (is_new && is_first) split.texture[point] = uv;
            if (is_new && !is_first) {
                split.points.push_back(static_cast<std::size_t>(point));
                split.texture.push_back(uv);
            }
            point = entry->second;
        }
    return split;
}

}  // namespace sherd
