// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/shell_energies.h"

namespace sherd {

ShellEnergies::ShellEnergies(const Shell& shell, const ShellEnergyOptions& options)
    : bending(bending_energy(shell, options.bending)),
      membrane(shell.triangles),
      mirrors(shell, options.mirrors) {
    if (!options.loads.empty()) outer.push_back(std::make_unique<LoadEnergy>(shell, options.loads));
    if (!options.winds.empty()) outer.push_back(std::make_unique<WindEnergy>(shell, options.winds));
    if (options.damping.stiffness > 0)
        outer.push_back(std::make_unique<StiffnessDamping>(shell, options.damping.stiffness));
    if (options.damping.mass > 0) outer.push_back(std::make_unique<MassDamping>(shell, options.damping.mass));
}

std::vector<Energy*> ShellEnergies::loads() {
    std::vector<Energy*> all;
    for (const std::unique_ptr<Energy>& energy : outer) all.push_back(energy.get());
    return all;
}

}  // namespace sherd
