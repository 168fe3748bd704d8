// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/split_points.h"

#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace sherd {
namespace {

/// Properties of a corner: point, texture coordinates u and v, colour of the face, and number of the
/// quadrilateral of a solid's rim or crack face. Corners with equal properties share a split point.
using Look = std::tuple<std::int32_t, double, double, Colour, std::size_t>;

Look look_of(const TriangleSheet& sheet, std::size_t t, int corner) {
    const Eigen::Vector2d uv =
        sheet.look.texture.empty() ? Eigen::Vector2d::Zero() : sheet.look.texture[t][corner];
    // The triangles at the end, in pairs, are the quadrilaterals of a solid's rim and crack faces.
    const bool is_side = sheet.shading.empty() || sheet.shading[t] == Shading::smooth;
    return {sheet.triangles[t][corner], uv.x(), uv.y(),
            sheet.look.face_colour.empty() ? white : sheet.look.face_colour[t],
            is_side ? std::numeric_limits<std::size_t>::max() : (sheet.triangles.size() - t - 1) / 2};
}

}  // namespace

SplitPoints split_points(const TriangleSheet& sheet) {
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    SplitPoints split;
    split.points.resize(sheet.points.size());
    std::iota(split.points.begin(), split.points.end(), std::size_t{0});
    split.corners.assign(sheet.points.size(), {none, 0});
    split.triangles = sheet.triangles;
    std::map<Look, std::int32_t> number;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            std::int32_t& point = split.triangles[t][k];
            const std::array<std::size_t, 2> corner{t, static_cast<std::size_t>(k)};
            const bool is_first = split.corners[point][0] == none;
            const auto next = static_cast<std::int32_t>(split.points.size());
            const auto [entry, is_new] = number.try_emplace(look_of(sheet, t, k), is_first ? point : next);
            if (is_first) split.corners[point] = corner;
            if (is_new && !is_first) {
                split.points.push_back(static_cast<std::size_t>(point));
                split.corners.push_back(corner);
            }
            point = entry->second;
        }
    return split;
}

}  // namespace sherd
