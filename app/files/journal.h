// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/files/disk_file.h"
#include "app/files/file_blocks.h"

namespace sherd {

/// What makes the last committed state of a file out of whatever a power cut has left of it: where it ends,
/// and blocks of it, which are replaced. It stands beside the file, as FILE.journal (app/README.md), and
/// holds its own checksum.
struct Journal {
    std::uint64_t end = 0;  ///< bytes of the file
    Blocks blocks;
};

/// Makes `journal` that of an open file, in place of the one before, if any: after a power cut there is
/// either one or the other, and the new one once the folder is on the disk (sync_folder_of()). Before it the
/// file itself must be (sync()). Throws Error (run); then it is still the one before.
void replace_journal(const DiskFile& file, const Journal& journal);
/// None when there is none, when it is incomplete, and when it is not of this file as it is: each of its
/// blocks must be what it was when the journal was written, or what it becomes.
std::optional<Journal> read_journal(const DiskFile& file);
void remove_journal(const std::filesystem::path& file);
bool has_journal(const std::filesystem::path& file);

/// Puts the blocks into the file and cuts it off at its end.
void apply(const Journal& journal, DiskFile& file);

/// Takes away what a writer that was killed has left: completes the file by its journal and removes that.
/// Does nothing while another program writes or reads the file, where nothing can be written, or when there
/// is no journal. Returns what has been done, for people; "" when the file was whole. The file can be read
/// all the same: OverlaidFile.
std::string mend(const std::filesystem::path& file);

}  // namespace sherd
