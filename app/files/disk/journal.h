// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "app/files/disk/disk_file.h"

namespace sherd {

/// Size of a block, bytes. A disk writes a block as a whole. Blocks begin at multiples of this size.
constexpr std::size_t block_size = 512;
using Block = std::array<std::byte, block_size>;
/// Blocks by number. The number of a block is its offset in the file divided by block_size.
using Blocks = std::map<std::uint64_t, Block>;

inline std::uint64_t block_of(std::uint64_t offset) {
    return offset / block_size;
}

/// `bytes` are at `offset` in a file. Calls visit(number of the block, offset within the block, part of
/// `bytes` in the block) for each block that overlaps them.
template <class Byte, class Visit>
void visit_blocks(std::uint64_t offset, std::span<Byte> bytes, Visit visit) {
    while (!bytes.empty()) {
        const std::size_t inside = offset % block_size;
        const std::size_t count = std::min(bytes.size(), block_size - inside);
        visit(block_of(offset), inside, bytes.first(count));
        offset += count;
        bytes = bytes.subspan(count);
    }
}

/// `bytes` were read from a file at `offset`. Overwrites them with the content of the blocks where these
/// overlap them.
inline void overlay(const Blocks& blocks, std::uint64_t offset, std::span<std::byte> bytes) {
    if (blocks.empty() || bytes.empty()) return;
    const auto last = blocks.upper_bound(block_of(offset + bytes.size() - 1));
    for (auto block = blocks.lower_bound(block_of(offset)); block != last; ++block) {
        const std::uint64_t start = block->first * block_size;
        const std::uint64_t from = std::max(start, offset);
        const std::uint64_t to = std::min(start + block_size, offset + bytes.size());
        std::copy_n(block->second.begin() + static_cast<std::ptrdiff_t>(from - start), to - from,
                    bytes.begin() + static_cast<std::ptrdiff_t>(from - offset));
    }
}

/// Journal of a file: the file's committed size, and new content for some of its blocks. The journal allows
/// restoring the last committed state after a power cut. It is stored beside the file, as FILE.journal
/// (docs/recording.md), with its own checksum.
struct Journal {
    std::uint64_t end = 0;  ///< bytes, committed size of the file
    Blocks blocks;
};

/// Replaces the journal of an open file. After a power cut either the old or the new journal exists; the new
/// one is certain to exist once the caller has written the folder to the disk (sync_folder_of()). The caller
/// must have written the file itself to the disk before (DiskFile::sync()). Throws Error (run) on failure;
/// the old journal then remains.
void replace_journal(const DiskFile& file, const Journal& journal);
/// Returns the journal of a file, or none if it is missing, incomplete or does not match the file. To match,
/// each block in the file must have the content that it had when the journal was written, or the new content
/// that the journal gives it.
std::optional<Journal> read_journal(const DiskFile& file);
void remove_journal(const std::filesystem::path& file);
bool has_journal(const std::filesystem::path& file);

/// Writes the journal's blocks into the file, and truncates the file to its committed size.
void apply(const Journal& journal, DiskFile& file);

/// Repairs a file that a killed writer has left: applies the file's journal, and removes the journal. An
/// incomplete journal is only removed; one that does not match the file is left. Does nothing if there is no
/// journal, if another program writes or reads the file, or if the file is read-only. Returns a message for
/// users on what was done or found, or "". Reading needs no repair: OverlaidFile takes the journal into
/// account.
std::string recover(const std::filesystem::path& file);

}  // namespace sherd
