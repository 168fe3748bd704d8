// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <unordered_map>

#include "app/files/disk_file.h"
#include "app/files/output_lock.h"
#include "app/sweep/row_result.h"

namespace sherd {

/// Results by StudyRow::identity.
using RowResults = std::unordered_map<std::uint64_t, RowResult>;

/// A file of results that one program appends to, a line each. A line that a killed program has not written
/// to its end is cut off by the next one, and passed over by who reads meanwhile.
class ResultJournal {
  public:
    /// Takes the file that is there, or makes it. Throws Error: (input) when another program has it.
    explicit ResultJournal(const std::filesystem::path& file);
    void append(const RowResult& result);

  private:
    OutputLock lock;
    DiskFile file;
    std::uint64_t end = 0;
};

/// All results of a folder's journals (`*.jsonl`). Of one row the last of a journal counts, and of several
/// journals one that has not failed. A folder that is not there has none.
RowResults read_results(const std::filesystem::path& folder);

}  // namespace sherd
