// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

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

}  // namespace sherd
