// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/shell_energies.h"

#include <algorithm>

#include "core/bending/hinge_curvature.h"
#include "core/membrane/arc_membrane.h"
#include "core/shell/face_fields.h"

namespace sherd {
namespace {

/// The mirrors that need a separate energy: none with coupled hinges, whose energy includes them.
std::vector<MirrorHinge> uncoupled_mirrors(const ShellEnergyOptions& options) {
    return options.bending.model == BendingModel::coupled ? std::vector<MirrorHinge>() : options.mirrors;
}

/// Sets the yield stresses of the bending energy. Returns the energy if its hinges are coupled and a sheet
/// yields; else null.
CoupledBending* yielding_part(Energy& bending, const ShellEnergyOptions& options) {
    if (options.yields.empty()) return nullptr;
    auto* coupled = dynamic_cast<CoupledBending*>(&bending);
    if (coupled != nullptr) coupled->set_yield(options.yields);
    return coupled;
}

}  // namespace

ShellEnergies::ShellEnergies(const Shell& shell, const ShellEnergyOptions& options)
    : shell(shell),
      bending(bending_energy(shell, options.bending, options.mirrors)),
      coupled(coupled_hinges(*bending)),
      yielding(yielding_part(*bending, options)),
      membrane(membrane_energy(shell, options.membrane, options.mirrors)),
      arcs(dynamic_cast<const ArcMembrane*>(membrane.get())),
      mirrors(shell, uncoupled_mirrors(options)),
      mirror_supports(options.mirror_supports) {
    for (const MirrorHinge& mirror : options.mirrors) mirror_scripts.push_back(mirror.script);
    if (!options.loads.empty())
        others.push_back(
            {&EnergyBalance::work_of_loads, std::make_unique<LoadEnergy>(shell, options.loads), false});
    if (!options.winds.empty())
        others.push_back(
            {&EnergyBalance::work_of_wind, std::make_unique<WindEnergy>(shell, options.winds), true});
    if (options.given_forces) {
        auto forces = std::make_unique<GivenForces>(shell);
        given = forces.get();
        others.push_back({&EnergyBalance::work_of_loads, std::move(forces), false});
    }
    damp(options);
}

void ShellEnergies::damp(const ShellEnergyOptions& options) {
    std::erase_if(others, [](const OuterEnergy& one) { return one.part == &EnergyBalance::lost_to_damping; });
    const auto add = [&](std::unique_ptr<Energy> energy) {
        others.push_back({&EnergyBalance::lost_to_damping, std::move(energy), true});
    };
    if (options.damping.stiffness > 0)
        add(std::make_unique<StiffnessDamping>(shell, options.damping.stiffness, options.bending.model,
                                               options.membrane));
    if (options.damping.mass > 0) add(std::make_unique<MassDamping>(shell, options.damping.mass));
}

void ShellEnergies::visit_state(StateVisitor& visit) {
    auto& [shell, bending, coupled, yielding, membrane, arcs, mirrors, mirror_supports, mirror_scripts,
           others, given] = *this;
    visit(bending, membrane, mirrors);
    for (auto& [part, energy, of_velocity] : others) visit(energy);
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::coupled_curvatures(const Positions& x) const {
    if (coupled == nullptr) return std::nullopt;
    return coupled->curvatures(x);
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::plastic_curvatures(const Positions& x) const {
    if (yielding == nullptr) return std::nullopt;
    return yielding->plastic_curvatures(x);
}

Eigen::Matrix3Xd ShellEnergies::face_strains(const Positions& x) const {
    return arcs != nullptr ? arcs->strains(x) : green_strains(shell, x);
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::coupled_curvatures(const Positions& x,
                                                                  std::span<const Index> faces) const {
    if (coupled == nullptr) return std::nullopt;
    return coupled->curvatures(x, faces);
}

std::optional<Eigen::Matrix3Xd> ShellEnergies::plastic_curvatures(const Positions& x,
                                                                  std::span<const Index> faces) const {
    if (yielding == nullptr) return std::nullopt;
    return yielding->plastic_curvatures(x, faces);
}

Eigen::Matrix3Xd ShellEnergies::face_strains(const Positions& x, std::span<const Index> faces) const {
    if (arcs != nullptr) return arcs->strains(x)(Eigen::all, faces);
    return green_strains(shell, x, faces);
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
    for (const OuterEnergy& one : others) all.push_back(one.energy.get());
    return all;
}

void ShellEnergies::add_outer(const Positions& x, const Positions& moved, EnergyBalance& balance,
                              Positions& gradient) const {
    for (const auto& [part, energy, of_velocity] : others) {
        Positions own = Positions::Zero(3, x.cols());
        energy->add_gradient(x, own);
        balance.take(part, own.cwiseProduct(moved).sum());
        gradient += own;
    }
}

std::vector<Reaction> ShellEnergies::mirror_reactions(const Positions& x) const {
    std::vector<Reaction> all(mirror_scripts.size());
    const Mirrors& parts = coupled != nullptr ? coupled->all_folds().all_mirrors() : mirrors.all();
    const auto add = [&](const std::vector<MirrorGradient>& gradients) {
        for (std::size_t m = 0; m < gradients.size(); ++m)
            for (int k = 0; k < 4; ++k)
                if (const Index vertex = gradients[m].vertices[k]; vertex >= 0)
                    all[parts.origin(m)].add(x.col(vertex), -gradients[m].gradient.col(k));
    };
    add(coupled != nullptr ? coupled->mirror_gradients(x) : mirrors.gradients(x));
    if (arcs != nullptr) add(arcs->mirror_gradients(x));
    return all;
}

void ShellEnergies::add_mirror_reactions(const Positions& x, std::span<Reaction> of_supports) const {
    if (mirror_supports.empty()) return;
    const std::vector<Reaction> all = mirror_reactions(x);
    for (std::size_t m = 0; m < all.size(); ++m) {
        of_supports[mirror_supports[m]].force += all[m].force;
        of_supports[mirror_supports[m]].moment += all[m].moment;
    }
}

bool ShellEnergies::mirrors_move() const {
    return std::ranges::any_of(mirror_scripts, [](Index script) { return script != 0; });
}

double ShellEnergies::mirror_work(const StepContext& step, const Positions& x) const {
    if (!mirrors_move()) return 0;
    const std::vector<Reaction> all = mirror_reactions(x);
    double sum = 0;
    for (std::size_t m = 0; m < all.size(); ++m)
        if (mirror_scripts[m] > 0) {
            const Motion& motion = shell.motions[mirror_scripts[m] - 1];
            sum += work(all[m], motion.at(step.begin), motion.at(step.end()));
        }
    return sum;
}

}  // namespace sherd
