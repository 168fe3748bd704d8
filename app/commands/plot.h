// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/chart/chart.h"
#include "app/recording/recording.h"

namespace sherd {

/// Points of a chart from time 0 to `end` (s): time, and total length at rest (m) of the edges that have
/// failed until then. last: the last frame.
std::vector<Vector2d> crack_length(const Snapshot& last, const CrackEvents& events, double end);

/// Points of a chart, a point for each fragment: area at rest (m^2), ascending, and number of fragments that
/// are as large or larger.
std::vector<Vector2d> fragment_sizes(const Snapshot& last);

/// An SVG picture of a run: energies, fragments, crack length and peak strain over time, fragment sizes in
/// the last frame, and, if there are any, forces of supports and obstacles, gauges and crack tips. Throws
/// Error (input) if nothing has been recorded yet, or the recording shows modes of vibration.
std::string plot_svg(const Recording& recording);

}  // namespace sherd
