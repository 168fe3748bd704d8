// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/membrane/membrane.h"

#include "core/membrane/arc_membrane.h"
#include "core/membrane/membrane_energy.h"
#include "core/shell/thickness.h"

namespace sherd {

std::unique_ptr<Energy> membrane_energy(const Shell& shell, MembraneModel model,
                                        const std::vector<MirrorHinge>& mirrors) {
    if (model == MembraneModel::arc) return std::make_unique<ArcMembrane>(shell, mirrors);
    return std::make_unique<MembraneEnergy>(shell.triangles);
}

VectorXd locking(const Shell& shell) {
    const Folds folds(shell, {});
    const SideCurvature curvature(shell, folds);
    const VectorXd angles = folds.rest_angles();
    VectorXd all(shell.triangles.size());
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const std::array<Index, 3>& vertices = shell.triangles[face].vertices;
        const Vector3d squares = side_squares(columns(shell.rest, vertices));
        all[static_cast<Eigen::Index>(face)] =
            squares.cwiseProduct(curvature.of(face, angles)).cwiseAbs().maxCoeff() /
            mean_thickness(shell, vertices);
    }
    return all;
}

}  // namespace sherd
