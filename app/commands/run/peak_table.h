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

/// Returns rows for the sheets of a run in which nothing failed, in the scene's order. A sheet that can fail
/// has a row by the measure of its strength. The peak of a hinge is divided by the factor by which scatter,
/// maps, scores and directions change its strength, so that the peak exceeds a threshold exactly if the hinge
/// would have failed with this threshold as the strength of the sheet. A sheet that cannot fail has a row by
/// stress and a row by strain.
std::vector<PeakRow> peak_rows(const Scene& scene, const Simulation& simulation);

/// The smallest peak that at least this share of the peaks does not exceed. peaks: ascending, not empty.
double peak_quantile(std::span<const double> peaks, double share);

/// Up to three thresholds of one significant digit, descending. Each is exceeded by some hinges: about one in
/// a thousand, one in a hundred, one in ten. peaks: ascending, not empty.
std::vector<double> round_thresholds(std::span<const double> peaks);

/// Table of quantiles of the rows, and of the number of hinges above round_thresholds().
std::string peak_table(std::span<const PeakRow> rows);

}  // namespace sherd
