// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/sweep/table/csv.h"
#include "app/sweep/table/study_table.h"

namespace sherd {

/// Returns a table with a row for each point of a study: its parameters, the numbers of its rows that are
/// done and that have failed, and for each measure the mean over its rows and the confidence interval, in the
/// columns NAME, NAME.low and NAME.high.
CsvRows study_summary(const StudyRows& rows, const StudyTable& table);

}  // namespace sherd
