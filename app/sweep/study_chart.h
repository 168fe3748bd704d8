// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/chart/chart_page.h"
#include "app/sweep/study_table.h"

namespace sherd {

/// What is drawn of a table.
struct StudyAxes {
    std::string x, y;     ///< columns
    std::string by = {};  ///< column whose values have a colour each; empty: none
    bool log_x = false, log_y = false;
};

/// A dot for each row; where several rows have the same x, their mean with its interval by the bootstrap, and
/// a line through the means. Throws Error (input) when there is no such column, or no row with both numbers.
Chart study_chart(const StudyTable& table, const StudyAxes& axes);

/// Charts of all measures over the first parameter that has several numbers for its values; none without
/// such a parameter.
std::string summary_svg(const Study& study, const StudyTable& table);

}  // namespace sherd
