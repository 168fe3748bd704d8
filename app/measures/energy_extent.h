// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fracture/step/step_report.h"

namespace sherd {

/// An energy of a run, J, by the name of its column in /steps.
struct EnergyExtent {
    std::string name;
    double last = 0;     ///< at the last step
    double largest = 0;  ///< largest magnitude of all steps, signed
    double time = 0;     ///< s, time of the largest
};

/// Returns all energies of the steps, those of the balance only if there is one; empty without steps.
std::vector<EnergyExtent> energy_extents(const std::vector<StepReport>& steps, bool has_balance);

}  // namespace sherd
