// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/strength_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/scene/assemble/sheet/map_values.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<double> checked_values(const StrengthMap& map, const SheetSpec& sheet, const Mesh& placed,
                                   std::vector<std::string>& warnings) {
    std::vector<double> values = edge_values(map.source, sheet, placed, warnings);
    for (const Edge e : placed.edges()) {
        if (values[e] >= 0 && std::isfinite(values[e])) continue;
        const Eigen::Vector3d at = to_file(sheet) * edge_middle(placed, e);
        throw Error(
            fmt::format("{} is {} at ({:.4g}, {:.4g}, {:.4g}), in the middle of edge {}; a strength needs "
                        "values of 0 or more",
                        source_text(map.source), values[e], at.x(), at.y(), at.z(), e.idx()));
    }
    return values;
}

}  // namespace

std::vector<double> map_factors(const StrengthMap& map, const SheetSpec& sheet, const Mesh& placed,
                                std::vector<std::string>& warnings) {
    std::vector<std::string> found;
    std::vector<double> factors =
        with_context(map.where, [&] { return checked_values(map, sheet, placed, found); });
    for (const std::string& warning : found) warnings.push_back(fmt::format("{}: {}", map.where, warning));
    for (double& factor : factors) {
        if (map.never) factor = factor < 0.5 ? 1 : std::numeric_limits<double>::infinity();
        if (map.range) factor = std::lerp((*map.range)[0], (*map.range)[1], std::min(factor, 1.0));
    }
    return factors;
}

}  // namespace sherd
