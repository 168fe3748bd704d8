// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/stability.h"

#include "core/solver/linear_solver.h"
#include "core/solver/potential.h"
#include "core/time/implicit_euler.h"
#include "core/time/inertia.h"

namespace sherd {
namespace {

constexpr double growth_time = 0.1;  // s

}  // namespace

bool stable_at_rest(const Shell& shell, BendingModel model, MembraneModel membrane_model) {
    if (model == BendingModel::cubic_2007) model = BendingModel::cubic;
    const std::unique_ptr<Energy> bending = bending_energy(shell, {model, exact_jacobian(model)});
    const std::unique_ptr<Energy> membrane = membrane_energy(shell, membrane_model);
    // With the growth time as step, inertia on the diagonal outweighs instabilities that grow more slowly.
    TimeSpent spent;
    Inertia inertia(shell, Vector3d::Zero());
    inertia.begin(ImplicitEuler().begin(shell, {}, 0, growth_time));
    const Potential potential(shell, {&inertia, bending.get(), membrane.get()}, spent);
    BlockMatrix stiffness = potential.hessian_pattern(shell.rest);
    potential.hessian(shell.rest, Curvature::exact, stiffness);
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    solver->analyze(stiffness);
    return solver->factorize(stiffness);
}

}  // namespace sherd
