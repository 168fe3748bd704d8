// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/sweep/table/csv.h"
#include "app/sweep/table/study_table.h"

namespace sherd {

/// Returns a row for each point of a study: the parameters, the numbers of rows that are done and that
/// failed, and for each measure the mean of its rows with its interval, in the columns NAME, NAME.low and
/// NAME.high.
CsvRows study_summary(const StudyRows& rows, const StudyTable& table);

}  // namespace sherd
