// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_surface.h"

#include "core/contact/detection/box_tree.h"
#include "core/contact/geometry/distance.h"

namespace sherd {

std::vector<Index> near_surface(const Positions& points, const std::vector<std::array<Index, 3>>& triangles,
                                const Positions& x, const VectorXd& reach) {
    std::vector<Index> asked;
    std::vector<Box> around;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        if (reach[v] < 0) continue;
        asked.push_back(v);
        around.push_back({x.col(v).array() - reach[v], x.col(v).array() + reach[v]});
    }
    if (asked.empty()) return {};
    std::vector<Box> of_triangles(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const Index corner : triangles[t])
            of_triangles[t].include({points.col(corner), points.col(corner)});
    std::vector<char> found(asked.size(), 0);
    BoxTree(around).meet(BoxTree(of_triangles), [&](Index i, Index t) {
        PairPositions pair;
        pair << x.col(asked[i]), columns(points, triangles[t]);
        const double apart = squared_distance(closest_points(PairKind::vertex_triangle, pair), pair);
        if (apart < reach[asked[i]] * reach[asked[i]]) found[i] = 1;
    });
    std::vector<Index> near;
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (found[i]) near.push_back(asked[i]);
    return near;
}

}  // namespace sherd
