// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/sweep/csv.h"
#include "app/sweep/study_table.h"

namespace sherd {

/// Of each point of a study: the parameters, how many rows are done and failed, and of each measure the mean
/// of its rows with its interval: the columns NAME, NAME.low and NAME.high.
CsvRows study_summary(const StudyRows& rows, const StudyTable& table);

}  // namespace sherd
