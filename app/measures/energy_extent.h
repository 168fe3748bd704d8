// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fracture/step/step_report.h"

namespace sherd {

/// Last and largest value of an energy of a run.
struct EnergyExtent {
    std::string name;    ///< name of its column in the table /steps
    double last = 0;     ///< J, at the last step
    double largest = 0;  ///< J, value of largest magnitude in all steps, with its sign
    double time = 0;     ///< s, end of the step with the largest value
};

/// Returns the extents of all energies in `steps`; empty without steps. Energies of the balance (work, losses
/// and the unexplained rest) are left out unless `has_balance` is true.
std::vector<EnergyExtent> energy_extents(const std::vector<StepReport>& steps, bool has_balance);

}  // namespace sherd
