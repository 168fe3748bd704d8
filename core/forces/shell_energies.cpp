// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/shell_energies.h"

#include <utility>

#include "core/bending/coupled_bending.h"
#include "core/bending/hinge_curvature.h"

namespace sherd {
namespace {

/// The mirrors that have an energy of their own: coupled hinges count theirs.
std::vector<MirrorHinge> uncoupled_mirrors(const ShellEnergyOptions& options) {
    return options.bending.model == BendingModel::coupled ? std::vector<MirrorHinge>() : options.mirrors;
}

}  // namespace

ShellEnergies::ShellEnergies(const Shell& shell, const ShellEnergyOptions& options)
    : shell(shell),
      bending(bending_energy(shell, options.bending, options.mirrors)),
      coupled(dynamic_cast<const CoupledBending*>(bending.get())),
      membrane(shell.triangles),
      mirrors(shell, uncoupled_mirrors(options)),
      mirror_supports(options.mirror_supports) {
    for (std::size_t i = 0; i < mirror_supports.size() && coupled == nullptr; ++i) {
        const auto support = static_cast<std::size_t>(mirror_supports[i]);
        if (mirrors_of.size() <= support) mirrors_of.resize(support + 1);
        mirrors_of[support].push_back(options.mirrors.at(i));
    }
    if (!options.loads.empty()) outer.push_back(std::make_unique<LoadEnergy>(shell, options.loads));
    if (!options.winds.empty()) outer.push_back(std::make_unique<WindEnergy>(shell, options.winds));
    if (options.damping.stiffness > 0)
        outer.push_back(
            std::make_unique<StiffnessDamping>(shell, options.damping.stiffness, options.bending.model));
    if (options.damping.mass > 0) outer.push_back(std::make_unique<MassDamping>(shell, options.damping.mass));
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::coupled_curvatures(const Positions& x) const {
    if (coupled == nullptr) return std::nullopt;
    return coupled->curvatures(x);
}

Eigen::Matrix3Xd ShellEnergies::face_curvatures(const Positions& x) const {
    if (coupled != nullptr) return coupled->curvatures(x);
    VectorXd strains(shell.hinges.size());
    for (std::size_t i = 0; i < shell.hinges.size(); ++i)
        strains[static_cast<Eigen::Index>(i)] =
            hinge_strain(shell.hinges[i].rest, columns(x, shell.hinges[i].vertices));
    Eigen::Matrix3Xd curvatures =
        curvatures_of_hinges(shell, sides_of_hinges(shell), strains, AngleShare::by_height);
    add_mirror_curvatures(shell, mirrors.all(), x, curvatures);
    return curvatures;
}

std::vector<Energy*> ShellEnergies::loads() {
    std::vector<Energy*> all;
    for (const std::unique_ptr<Energy>& energy : outer) all.push_back(energy.get());
    return all;
}

void ShellEnergies::add_mirror_reactions(const StepContext& step, const Positions& x,
                                         std::span<Reaction> of_supports) const {
    if (coupled != nullptr && !mirror_supports.empty()) {
        const std::vector<CoupledBending::MirrorGradient> gradients = coupled->mirror_gradients(x);
        for (std::size_t m = 0; m < gradients.size(); ++m)
            for (int k = 0; k < 3; ++k)
                of_supports[mirror_supports[m]].add(x.col(gradients[m].vertices[k]),
                                                    -gradients[m].gradient.col(k));
    }
    for (std::size_t support = 0; support < mirrors_of.size(); ++support) {
        if (mirrors_of[support].empty()) continue;
        MirrorEnergy own(shell, mirrors_of[support]);
        own.begin(step);
        Positions gradient = Positions::Zero(3, x.cols());
        own.add_gradient(x, gradient);
        std::vector<char> added(x.cols(), 0);
        for (const MirrorHinge& hinge : mirrors_of[support])
            for (const Index v : edge_and_apex(shell, hinge.side))
                if (!std::exchange(added[v], char(1))) of_supports[support].add(x.col(v), -gradient.col(v));
    }
}

}  // namespace sherd
