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

/// Size of a block, bytes, which a disk writes as a whole. Blocks begin at multiples of it.
constexpr std::size_t block_size = 512;
using Block = std::array<std::byte, block_size>;
/// Blocks by number: offset in the file over block_size.
using Blocks = std::map<std::uint64_t, Block>;

inline std::uint64_t block_of(std::uint64_t offset) {
    return offset / block_size;
}

/// Calls visit(number of the block, offset in it, part of `bytes`) for each block that overlaps the bytes.
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

/// Overwrites bytes that were read from the file at `offset` with the blocks.
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
