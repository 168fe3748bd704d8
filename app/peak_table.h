// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// What the hinges of one sheet bore in a run, by one measure.
struct PeakRow {
    std::string name;           ///< of the sheet
    std::string measure;        ///< what it is, with its unit
    std::vector<double> peaks;  ///< of each hinge, ascending
};

/// For each sheet of a run in which nothing broke, in the scene's order: by the measure that it is judged by,
/// divided by what scatter, maps, scores and directions make of the threshold, so that a hinge is over a
/// threshold exactly if it would have broken with it; of a sheet that cannot break by stress and by strain.
std::vector<PeakRow> peak_rows(const Scene& scene, const Simulation& simulation);

/// The least value that this share of them does not exceed; peaks: ascending, at least one.
double quantile(std::span<const double> peaks, double share);

/// Up to three thresholds of one digit, descending, each of which some hinges are over: about one of a
/// thousand, of a hundred, and of ten.
std::vector<double> round_thresholds(std::span<const double> peaks);

/// Quantiles of the rows, and how many hinges would have been over thresholds of round numbers, as a table.
std::string peak_table(std::span<const PeakRow> rows);

}  // namespace sherd
