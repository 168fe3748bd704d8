// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/files/disk_file.h"
#include "app/files/file_blocks.h"

namespace sherd {

/// Journal of a file: its committed size, and blocks that replace those in it. With it the last committed
/// state can be restored after a power cut. It is stored beside the file, as FILE.journal
/// (docs/recording.md), with its own checksum.
struct Journal {
    std::uint64_t end = 0;  ///< bytes, size of the file
    Blocks blocks;
};

/// Replaces the journal of an open file: after a power cut either the old or the new one exists, and the new
/// one once the folder is on the disk (sync_folder_of()). The file itself must be on the disk before
/// (sync()). Throws Error (run); the old journal then remains.
void replace_journal(const DiskFile& file, const Journal& journal);
/// Returns the journal of a file. None if it is missing or incomplete, or does not match the file, each block
/// of which must be what it was when the journal was written, or what it becomes.
std::optional<Journal> read_journal(const DiskFile& file);
void remove_journal(const std::filesystem::path& file);
bool has_journal(const std::filesystem::path& file);

/// Writes the blocks into the file and truncates it to its committed size.
void apply(const Journal& journal, DiskFile& file);

/// Repairs a file that a killed writer has left: applies its journal and removes that. Does nothing while
/// another program writes or reads the file, if nothing can be written, or without a journal. Returns a
/// description of the repair for users, or "". OverlaidFile reads files that have not been repaired, too.
std::string recover(const std::filesystem::path& file);

}  // namespace sherd
