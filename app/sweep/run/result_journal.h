// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <unordered_map>

#include "app/files/disk/disk_file.h"
#include "app/files/disk/output_lock.h"
#include "app/sweep/run/row_result.h"

namespace sherd {

/// Results by StudyRow::identity.
using RowResults = std::unordered_map<std::uint64_t, RowResult>;

/// A file of results to which a single program appends, a line each. A line that a killed program has not
/// written completely is cut off by the next program, and ignored by readers.
class ResultJournal {
  public:
    /// Opens the file, or creates it. Throws Error: (input) when another program has it.
    explicit ResultJournal(const std::filesystem::path& file);
    void append(const RowResult& result);

  private:
    OutputLock lock;
    DiskFile file;
    std::uint64_t end = 0;
};

/// Reads all results of a folder's journals (`*.jsonl`). For a row, the last result of a journal counts, and
/// of several journals one that has not failed. A missing folder has none.
RowResults read_results(const std::filesystem::path& folder);

}  // namespace sherd
