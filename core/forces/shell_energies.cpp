// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/shell_energies.h"

#include <utility>

#include "core/bending/coupled_bending.h"
#include "core/membrane/arc_membrane.h"

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
      membrane(membrane_energy(shell, options.membrane, options.mirrors)),
      arcs(dynamic_cast<const ArcMembrane*>(membrane.get())),
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
        outer.push_back(std::make_unique<StiffnessDamping>(shell, options.damping.stiffness,
                                                           options.bending.model, options.membrane));
    if (options.damping.mass > 0) outer.push_back(std::make_unique<MassDamping>(shell, options.damping.mass));
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::face_curvatures(const Positions& x) const {
    if (coupled == nullptr) return std::nullopt;
    return coupled->curvatures(x);
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::face_stretches(const Positions& x) const {
    if (arcs == nullptr) return std::nullopt;
    return arcs->strains(x);
}

std::vector<Energy*> ShellEnergies::loads() {
    std::vector<Energy*> all;
    for (const std::unique_ptr<Energy>& energy : outer) all.push_back(energy.get());
    return all;
}

void ShellEnergies::add_fold_reactions(const Positions& x, std::span<Reaction> of_supports) const {
    const auto add = [&](const std::vector<Folds::MirrorGradient>& gradients) {
        for (std::size_t m = 0; m < gradients.size(); ++m)
            for (int k = 0; k < 3; ++k)
                of_supports[mirror_supports[m]].add(x.col(gradients[m].vertices[k]),
                                                    -gradients[m].gradient.col(k));
    };
    if (coupled != nullptr) add(coupled->mirror_gradients(x));
    if (arcs != nullptr) add(arcs->mirror_gradients(x));
}

void ShellEnergies::add_mirror_reactions(const StepContext& step, const Positions& x,
                                         std::span<Reaction> of_supports) const {
    if (!mirror_supports.empty()) add_fold_reactions(x, of_supports);
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
