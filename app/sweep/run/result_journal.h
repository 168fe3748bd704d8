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

/// A file of results, one a line, to which a single program appends. A line that a killed program has not
/// written completely is cut off by the next program, and ignored by readers.
class ResultJournal {
  public:
    /// Opens the file, or creates it. Throws Error (input) when another program has its lock.
    explicit ResultJournal(const std::filesystem::path& file);
    void append(const RowResult& result);

  private:
    OutputLock lock;
    DiskFile file;
    std::uint64_t end = 0;
};

/// Reads all results of a folder's journals (`*.jsonl`). If a journal has several results of a row, the last
/// one counts; if several journals have results of a row, a result that has not failed is preferred. A
/// missing folder has no results.
RowResults read_results(const std::filesystem::path& folder);

}  // namespace sherd
