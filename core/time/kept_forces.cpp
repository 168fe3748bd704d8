// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/kept_forces.h"

namespace sherd {
namespace {

constexpr double least_force = 1e-10;  // share of the largest force

}  // namespace

KeptForces::KeptForces(const Positions& of_all) {
    const VectorXd sizes = of_all.colwise().norm();
    const double least = least_force * sizes.maxCoeff();
    for (Index v = 0; v < static_cast<Index>(sizes.size()); ++v)
        if (sizes[v] > least) vertices.push_back(v);
    forces = of_these(of_all);
}

void KeptForces::add(double share, Positions& sum) const {
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sum.col(vertices[i]) += share * forces.col(static_cast<Index>(i));
}

}  // namespace sherd
