// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/scene_mechanics.h"

#include <fmt/format.h>

#include <utility>

#include "core/bending/bending.h"
#include "meshops/error.h"

namespace sherd::python {
namespace {

/// Returns options with the exact second derivative of the energy.
ShellEnergyOptions exact(ShellEnergyOptions options) {
    options.bending.jacobian = exact_jacobian(options.bending.model);
    return options;
}

}  // namespace

SceneMechanics::SceneMechanics(const Scene& scene)
    : built(build_scene(scene, warning_list)), all(shell(), exact(built.options.stepper.shell)) {
    const StepContext start{0, 0, 0, shell().position, shell().velocity, {}};
    for (Energy* energy : all.elastic()) energy->begin(start);
}

Positions SceneMechanics::placed(Positions positions) const {
    if (positions.cols() != shell().position.cols())
        throw Error(fmt::format("positions: has {} rows, and the sheets have {} vertices", positions.cols(),
                                shell().position.cols()));
    return positions;
}

SceneMechanics::Parts SceneMechanics::energies(const Positions& x) {
    return {all.bending_value(x), all.membrane_value(x)};
}

Positions SceneMechanics::gradient(const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    for (const Energy* energy : all.elastic()) energy->add_gradient(x, sum);
    return sum;
}

BlockMatrix SceneMechanics::hessian(const Positions& x) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Energy* energy : all.elastic()) energy->add_pattern(pairs);
    const auto vertices = static_cast<Index>(x.cols());
    BlockMatrix sum(vertices, pairs, std::vector<char>(static_cast<std::size_t>(vertices), 0));
    for (const Energy* energy : all.elastic()) energy->add_hessian(x, Curvature::exact, sum);
    return sum;
}

FaceFields SceneMechanics::fields(const Positions& x) {
    return face_fields(shell(), all.face_strains(x), all.face_curvatures(x), {true, true, true});
}

}  // namespace sherd::python
