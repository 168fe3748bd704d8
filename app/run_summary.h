// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/run/run_end.h"
#include "app/run/run_totals.h"
#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// The table that is printed at the end of a run. It includes the peaks of the hinges if nothing failed, and
/// the names of obstacles that nothing touched.
std::string run_summary(const RunTotals& totals, const RunEnd& end, const std::filesystem::path& recording,
                        const Scene& scene, const Simulation& simulation);

}  // namespace sherd
