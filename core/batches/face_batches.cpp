// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/face_batches.h"

#include "core/elements/fold_gradient.h"
#include "core/elements/membrane_stress.h"

namespace sherd {
namespace {

using LanesMatrix = Eigen::Matrix<Lanes, 3, 3>;

/// Index, in a batch's six numbers, of each entry of the symmetric matrix.
constexpr int entry[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

}  // namespace

void FaceBatches::build(const Shell& shell, CornerSums& corners) {
    const std::size_t count = shell.triangles.size();
    batches.assign(batches_of(count), {});
    for (Index b = 0; b < size(); ++b) {
        Batch& batch = batches[b];
        for (int lane = 0; lane < Lanes::count; ++lane) {
            const auto& [vertices, membrane] = shell.triangles[element_of(b, lane, count)];
            for (int i = 0; i < 3; ++i) {
                batch.vertices[i][lane] = vertices[i];
                for (int j = 0; j < 3; ++j)
                    batch.stiffness[entry[i][j]].set(lane, membrane.area * membrane.elasticity(i, j));
                if (i > 0)
                    for (int j = 0; j < 2; ++j)
                        batch.derivatives[i - 1][j].set(lane, membrane.derivatives(i, j));
            }
        }
        batch.place = corners.append(batch.vertices, present_in(b, count));
    }
}

void FaceBatches::find(Index begin, Index end, const PaddedPositions& x, const SideMoments* bending,
                       CornerSums& corners) const {
    const bool bent = bending != nullptr;
    wide_loop(begin, end, [&](Index b) {
        const Batch& batch = batches[b];
        const auto& D = batch.derivatives;
        const LanesVector start = gather(x, batch.vertices[0]);
        const LanesVector one = gather(x, batch.vertices[1]) - start;
        const LanesVector other = gather(x, batch.vertices[2]) - start;
        Eigen::Matrix<Lanes, 3, 2> F;
        for (int i = 0; i < 2; ++i) F.col(i) = D[0][i] * one + D[1][i] * other;
        const LanesVector strain = strain_of(F);
        LanesVector stress;
        for (int i = 0; i < 3; ++i)
            stress[i] = batch.stiffness[entry[i][0]] * strain[0] + batch.stiffness[entry[i][1]] * strain[1] +
                        batch.stiffness[entry[i][2]] * strain[2];
        const Eigen::Matrix<Lanes, 3, 2> P = pulled(F, stress);
        LanesMatrix gradient;
        for (int i = 0; i < 2; ++i) gradient.col(i + 1) = D[i][0] * P.col(0) + D[i][1] * P.col(1);
        gradient.col(0) = -(gradient.col(1) + gradient.col(2));
        if (bent) {
            LanesMatrix edges;
            edges.col(0) = other - one;
            edges.col(1) = -other;
            edges.col(2) = one;
            gradient += fold_gradient(edges, bending->of(b));
        }
        for (int i = 0; i < 3; ++i) scatter(gradient.col(i), corners.at(batch.place + i * Lanes::count));
    });
}

}  // namespace sherd
