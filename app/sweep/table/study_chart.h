// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/chart/chart_page.h"
#include "app/sweep/table/study_table.h"

namespace sherd {

/// Columns and axes of a chart of a table.
struct StudyAxes {
    std::string x, y;     ///< names of the columns
    std::string by = {};  ///< name of the column each of whose values has its own colour; empty: none
    bool log_x = false, log_y = false;
};

/// Returns a chart with a dot for each row. Where several rows have the same x, it also has their mean, with
/// its interval by the bootstrap, and a line through the means. Throws Error (input) if a column is missing,
/// or if no row has numbers in both.
Chart study_chart(const StudyTable& table, const StudyAxes& axes);

/// Returns the text of an SVG file with charts of all measures over the first parameter that has several
/// different numbers; "" without such a parameter.
std::string summary_svg(const Study& study, const StudyTable& table);

}  // namespace sherd
