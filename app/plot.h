// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/chart/chart.h"
#include "app/recording/recording.h"

namespace sherd {

/// Time (s) and length (m) of all edges that have failed until then, as long as they are at rest; from 0 to
/// `end`. last: the last frame.
std::vector<Vector2d> crack_length(const Snapshot& last, const CrackEvents& events, double end);

/// Area (m^2, at rest) of each fragment, ascending, and how many are as large or larger.
std::vector<Vector2d> fragment_sizes(const Snapshot& last);

/// An SVG picture of a run: energies, fragments, crack length and peak strain over time, the sizes of the
/// fragments in the last frame, and where there are any the forces of supports and obstacles and the gauges.
/// Throws Error (input) when nothing has been recorded yet.
std::string plot_svg(const Recording& recording);

}  // namespace sherd
