// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/chart/chart_page.h"
#include "app/sweep/table/study_table.h"

namespace sherd {

/// Columns and axes of a chart of a table.
struct StudyAxes {
    std::string x, y;     ///< columns
    std::string by = {};  ///< column whose values have a colour each; empty: none
    bool log_x = false, log_y = false;
};

/// Returns a chart with a dot for each row; where several rows have the same x, with their mean and its
/// interval by the bootstrap, and a line through the means. Throws Error (input) if there is no such column,
/// or no row with both numbers.
Chart study_chart(const StudyTable& table, const StudyAxes& axes);

/// Returns an SVG file with charts of all measures over the first parameter that has several numbers for its
/// values; "" without such a parameter.
std::string summary_svg(const Study& study, const StudyTable& table);

}  // namespace sherd
