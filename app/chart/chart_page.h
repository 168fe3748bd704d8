// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/chart/chart.h"

namespace sherd {

/// Charts beside and below each other.
struct ChartPage {
    std::string heading;  ///< above all charts
    std::vector<Chart> charts = {};
    std::size_t columns = 2;
    double panel_width = 500, panel_height = 270;  ///< pixels
    bool shares_legend = false;  ///< whether all charts have lines of the same names, which are shown once
};

/// The page as an SVG file.
std::string page_svg(ChartPage page);

}  // namespace sherd
