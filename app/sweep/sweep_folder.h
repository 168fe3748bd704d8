// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/files/output_lock.h"
#include "app/sweep/result_journal.h"
#include "app/sweep/study_row.h"

namespace sherd {

// What is in the folder of a sweep:
//
//     rows/*.jsonl   journals of results
//     runs/*.h5      recordings that are kept, or that a killed run goes on with
//     study.csv, study.h5, summary.csv, summary.svg

/// Makes the folder and those in it.
void make_sweep_folder(const std::filesystem::path& folder);

/// The journal of the rows from `begin` to `end`, the last one not included.
std::filesystem::path journal_file(const std::filesystem::path& folder, std::size_t begin, std::size_t end);

RowResults results_in(const std::filesystem::path& folder);

/// How far a study is.
struct SweepState {
    std::vector<std::size_t> missing = {};  ///< rows to run: of those with the same scene the first
    std::vector<std::size_t> failed = {};   ///< all that failed
    std::size_t done = 0;
    std::size_t of_other_program = 0;  ///< done or failed by another build of it
    std::size_t foreign = 0;           ///< results of rows that the study does not have
};
SweepState sweep_state(const StudyRows& rows, const RowResults& results);

/// For people, of the rows that failed: the first ones with their messages.
std::string failed_lines(const StudyRows& rows, const RowResults& results,
                         std::span<const std::size_t> failed);

/// Writes the tables and the pictures; returns their names. lock: of study.csv in the folder.
std::vector<std::filesystem::path> write_tables(const Study& study, const StudyRows& rows,
                                                const RowResults& results, const OutputLock& lock);

}  // namespace sherd
