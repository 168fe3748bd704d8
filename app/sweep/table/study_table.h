// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/files/disk/output_lock.h"
#include "app/sweep/run/result_journal.h"
#include "app/sweep/study/study_row.h"
#include "app/sweep/table/csv.h"

namespace sherd {

/// A column of a study's table; a cell is empty if a row has no value.
struct StudyColumn {
    std::string group;  ///< group in the .h5: "parameters", "measures", "python" or "run"
    std::string name, unit;
    std::vector<std::string> cells;

    /// Returns the cells as numbers, NaN if a cell is none.
    std::vector<double> numbers() const;
};

/// Table with a row for each run, in the order of the study, whether it has been run or not.
using StudyTable = std::vector<StudyColumn>;

/// Returns the table of a study. folder: that of the sweep, with the recordings.
StudyTable study_table(const Study& study, const StudyRows& rows, const RowResults& results,
                       const std::filesystem::path& folder);

CsvRows csv_rows(const StudyTable& table);
/// Reads the result of csv_rows(), without groups. Throws Error (input).
StudyTable read_study_table(const std::filesystem::path& csv);

/// Returns the column of this name, or the only one whose last part it is ("velocity" for
/// "sheet.plate.velocity"). Throws Error (input), with the nearest name, if there is none.
const StudyColumn& find_column(const StudyTable& table, const std::string& name);

/// Writes the table as HDF5: columns of numbers as doubles (NaN: none), others as texts, with their units.
void write_study_h5(const StudyTable& table, const OutputLock& whole, const std::filesystem::path& file);

}  // namespace sherd
