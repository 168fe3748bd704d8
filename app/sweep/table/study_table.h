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

/// A column of a study's table. A cell is empty if its row has no value.
struct StudyColumn {
    std::string group;  ///< group in the .h5 file: "parameters", "measures", "python" or "run"
    std::string name, unit;
    std::vector<std::string> cells;

    /// Returns the cells as numbers, NaN for a cell that is no number.
    std::vector<double> numbers() const;
};

/// Table of a study, as columns. It has a row for each row of the study, in the study's order, whether the
/// row has been run or not.
using StudyTable = std::vector<StudyColumn>;

/// Returns the table of a study. folder: folder of the sweep, with the recordings.
StudyTable study_table(const Study& study, const StudyRows& rows, const RowResults& results,
                       const std::filesystem::path& folder);

CsvRows csv_rows(const StudyTable& table);
/// Reads a table from a CSV file with the rows of csv_rows(); its columns have no group. Throws Error (input)
/// if the file cannot be read, is empty, or is no such table.
StudyTable read_study_table(const std::filesystem::path& csv);

/// Returns the column of this name, or else the only column whose name ends with it behind a dot ("velocity"
/// for "sheet.plate.velocity"). Throws Error (input), with the most similar name, if there is no such column,
/// or several.
const StudyColumn& find_column(const StudyTable& table, const std::string& name);

/// Writes the table as HDF5: columns of numbers as doubles with their units (NaN for an empty cell), other
/// columns as texts. whole: lock of the sweep's output.
void write_study_h5(const StudyTable& table, const OutputLock& whole, const std::filesystem::path& file);

}  // namespace sherd
