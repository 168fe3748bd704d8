// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/files/disk/output_lock.h"
#include "app/sweep/run/result_journal.h"
#include "app/sweep/study/study_row.h"

namespace sherd {

// Contents of the folder of a sweep:
//
//     rows/*.jsonl   journals of results
//     runs/*.h5      recordings that are kept, or of killed runs that can be resumed
//     study.csv, study.h5, summary.csv, summary.svg

/// Creates the folder of a sweep and its subfolders.
void make_sweep_folder(const std::filesystem::path& folder);

/// Returns the journal of the rows from `begin` on, up to but without `end`.
std::filesystem::path journal_file(const std::filesystem::path& folder, std::size_t begin, std::size_t end);

RowResults results_in(const std::filesystem::path& folder);

/// Progress of a study.
struct SweepState {
    std::vector<std::size_t> missing = {};  ///< rows without a result: the first of all that have the same
                                            ///< identity
    std::vector<std::size_t> failed = {};   ///< rows that have failed
    std::size_t done = 0;
    std::size_t of_other_program = 0;  ///< number of rows done or failed by another build of the program
    std::size_t foreign = 0;           ///< number of results of rows that the study does not have
};
SweepState sweep_state(const StudyRows& rows, const RowResults& results);

/// Returns lines for users on rows that have failed: the messages of the first ten, and the number of the
/// others.
std::string failed_lines(const StudyRows& rows, const RowResults& results,
                         std::span<const std::size_t> failed);

/// Writes the tables and the picture of a study, and returns their paths. lock: lock of study.csv in the
/// folder.
std::vector<std::filesystem::path> write_tables(const Study& study, const StudyRows& rows,
                                                const RowResults& results, const OutputLock& lock);

}  // namespace sherd
