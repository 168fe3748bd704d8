// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/fracture/grown_crack.h"

#include <algorithm>
#include <cmath>

namespace sherd {

FirstCrack::FirstCrack(const Scene& scene) {
    const auto& line = std::get<ScoreLine>(scene.sheets.front().fracture->cracks.front().kind);
    from = line.points.front().head<2>();
    to = line.points.back().head<2>();
}

double FirstCrack::angle() const {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

std::vector<GrownEdge> grown_edges(const FractureHistory& run) {
    const FirstCrack crack(run.scene);
    std::vector<Vector2d> tips{crack.from, crack.to};
    std::vector<GrownEdge> edges;
    for (const EdgeFailure& failure : run.events.failures) {
        if (failure.step == 0) continue;
        Vector2d a = run.rest.col(failure.vertices[0]).head<2>(),
                 b = run.rest.col(failure.vertices[1]).head<2>();
        const auto away = [&](const Vector2d& end) {
            double least = (end - tips.front()).norm();
            for (const Vector2d& tip : tips) least = std::min(least, (end - tip).norm());
            return least;
        };
        if (away(b) < away(a)) std::swap(a, b);
        edges.push_back({a, b, failure.step});
        *std::ranges::min_element(tips, {}, [&](const Vector2d& tip) { return (tip - a).norm(); }) = b;
    }
    return edges;
}

std::vector<TipRecord> last_tips(const FractureHistory& run) {
    std::vector<TipRecord> last;
    for (const TipRecord& tip : run.events.tips)
        if (tip.step == run.steps.back().step) last.push_back(tip);
    return last;
}

std::array<Vector2d, 2> outline_corners(const Scene& scene) {
    const auto& outline = std::get<GeneratedMesh>(scene.sheets.front().mesh).polygon.outline;
    std::array<Vector2d, 2> corners{outline.front(), outline.front()};
    for (const Vector2d& point : outline) corners = {corners[0].cwiseMin(point), corners[1].cwiseMax(point)};
    return corners;
}

}  // namespace sherd
