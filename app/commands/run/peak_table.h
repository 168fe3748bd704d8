// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Peaks of the hinges of one sheet in a run, by one measure.
struct PeakRow {
    std::string name;           ///< name of the sheet
    std::string measure;        ///< name of the measure, with its unit
    std::vector<double> peaks;  ///< peaks of all hinges, ascending
};

/// Rows for each sheet of a run in which nothing failed, in the scene's order: by the measure of the sheet's
/// strength, divided by the factor of scatter, maps, scores and directions on the strength, so that a peak
/// exceeds a threshold exactly if the hinge would have failed with this threshold. A sheet that cannot fail
/// has rows by stress and by strain.
std::vector<PeakRow> peak_rows(const Scene& scene, const Simulation& simulation);

/// The smallest peak that this share of the peaks does not exceed. peaks: ascending, at least one.
double peak_quantile(std::span<const double> peaks, double share);

/// Up to three thresholds of one significant digit, descending, which some hinges exceed: about one in a
/// thousand, in a hundred, and in ten.
std::vector<double> round_thresholds(std::span<const double> peaks);

/// Table of quantiles of the rows, and of the number of hinges above round thresholds.
std::string peak_table(std::span<const PeakRow> rows);

}  // namespace sherd
