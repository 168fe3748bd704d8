// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/hinge_batches.h"

#include <Eigen/Geometry>

namespace sherd {

void HingeBatches::build(const Shell& shell, const std::vector<CubicHinge>& hinges, CornerSums& corners) {
    const std::size_t count = shell.hinges.size();
    batches.assign(batches_of(count), {});
    for (Index b = 0; b < size(); ++b) {
        Batch& batch = batches[b];
        for (int lane = 0; lane < Lanes::count; ++lane) {
            const Index hinge = element_of(b, lane, count);
            const Matrix3d Q = hinges[hinge].quadratic.bottomRightCorner<3, 3>();
            const double entries[] = {Q(0, 0), Q(1, 1), Q(2, 2), Q(0, 1), Q(0, 2), Q(1, 2)};
            for (int k = 0; k < 6; ++k) batch.quadratic[k].set(lane, entries[k]);
            batch.cubic.set(lane, hinges[hinge].cubic);
            for (int v = 0; v < 4; ++v) batch.vertices[v][lane] = shell.hinges[hinge].vertices[v];
        }
        batch.place = corners.append(batch.vertices, present_in(b, count));
    }
}

void HingeBatches::find(Index begin, Index end, const PaddedPositions& x, CornerSums& corners) const {
    wide_loop(begin, end, [&](Index b) {
        const auto& [Q, k, vertices, place] = batches[b];
        const LanesVector start = gather(x, vertices[0]);
        const LanesVector e0 = gather(x, vertices[1]) - start, e1 = gather(x, vertices[2]) - start,
                          e2 = gather(x, vertices[3]) - start;
        const LanesVector g1 = Q[0] * e0 + Q[3] * e1 + Q[4] * e2 - k * e1.cross(e2);
        const LanesVector g2 = Q[3] * e0 + Q[1] * e1 + Q[5] * e2 - k * e2.cross(e0);
        const LanesVector g3 = Q[4] * e0 + Q[5] * e1 + Q[2] * e2 - k * e0.cross(e1);
        scatter(-(g1 + g2 + g3), corners.at(place));  // the rows of Q sum to zero
        scatter(g1, corners.at(place + Lanes::count));
        scatter(g2, corners.at(place + 2 * Lanes::count));
        scatter(g3, corners.at(place + 3 * Lanes::count));
    });
}

}  // namespace sherd
