// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/newton_cost.h"

#include "app/machine/processor_time.h"
#include "app/scene/assemble/built_scene.h"
#include "core/solver/linear/factor_size.h"
#include "core/solver/linear/linear_solver.h"

namespace sherd {
namespace {

BlockMatrix laid_out(const Shell& shell, const std::vector<Energy*>& energies) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Energy* energy : energies) energy->add_pattern(pairs);
    return {static_cast<Index>(shell.mass.size()), pairs, shell.fixed, shell.guide, shell.guides};
}

/// Adds the inertia of implicit Euler with this step, s.
void add_inertia(const VectorXd& mass, double step, BlockMatrix& matrix) {
    for (Index v = 0; v < mass.size(); ++v) matrix.add(v, v, mass[v] / (step * step) * Matrix3d::Identity());
}

}  // namespace

NewtonCost newton_cost(const Scene& scene) {
    std::vector<std::string> warnings;
    const BuiltScene built = build_scene(scene, warnings);
    const Shell& shell = built.sheets.mechanics();
    ShellEnergies energies(shell, built.options.stepper.shell);
    const std::vector<Energy*> all = energies.elastic();
    const Positions& x = shell.position;
    NewtonCost cost;
    cost.layout = least_seconds([&] { laid_out(shell, all); });
    BlockMatrix matrix = laid_out(shell, all);
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    cost.analysis = least_seconds([&] { solver->analyze(matrix); });
    Positions gradient = Positions::Zero(3, x.cols());
    double sum = 0;
    const auto assemble = [&] {
        matrix.set_zero();
        for (const Energy* energy : all) energy->add_hessian(x, Curvature::exact, matrix);
        if (!scene.is_static()) add_inertia(shell.mass, scene.simulation.stepper.step, matrix);
    };
    cost.vertices = shell.mass.size();
    const auto vertices = static_cast<double>(cost.vertices);
    cost.hessian_entries = (2 * static_cast<double>(matrix.values().size()) - matrix.size()) / vertices;
    cost.factor_entries = factor_size(matrix) / vertices;
    cost.gradient = least_seconds([&] {
        for (const Energy* energy : all) energy->add_gradient(x, gradient);
    });
    cost.hessian = least_seconds(assemble);
    cost.factorization = least_seconds([&] { solver->factorize(matrix); });
    const VectorXd right_side = VectorXd::Ones(matrix.size());
    cost.solution = least_seconds([&] { sum += solver->solve(right_side).sum(); });
    const double energy = least_seconds([&] {
        for (const Energy* one : all) sum += one->value(x);
    });
    cost.iteration = cost.gradient + cost.hessian + cost.factorization + cost.solution + energy;
    return cost;
}

}  // namespace sherd
