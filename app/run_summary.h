// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/run/run_end.h"
#include "app/run/run_totals.h"
#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// The table that a run ends with, for people. When nothing broke it has the peaks of the hinges, and where
/// nothing touched an obstacle its name.
std::string run_summary(const RunTotals& totals, const RunEnd& end, const std::filesystem::path& recording,
                        const Scene& scene, const Simulation& simulation);

}  // namespace sherd
