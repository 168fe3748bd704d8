// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stability.h"

#include "core/incremental_potential.h"
#include "core/linear_solver.h"

namespace sherd {
namespace {

constexpr double growth_time = 0.1;  // s

}  // namespace

bool stable_at_rest(const Sheet& sheet, BendingModel model) {
    if (model == BendingModel::cubic_2007) model = BendingModel::cubic;
    const BendingEnergy bending(sheet.hinges, {model, exact_jacobian(model)});
    const MembraneEnergy membrane(sheet.triangles);
    // With a step of the growth time, the masses on the diagonal outweigh what grows more slowly.
    TimeSpent spent;
    const IncrementalPotential potential(sheet, {&bending, &membrane}, growth_time, Vector3d::Zero(), spent);
    BlockMatrix stiffness = potential.hessian_pattern(sheet.rest);
    potential.hessian(sheet.rest, Curvature::exact, stiffness);
    LinearSolver solver;
    solver.analyze(stiffness);
    return solver.factorize(stiffness);
}

}  // namespace sherd
