// SPDX-License-Identifier: GPL-3.0-or-later
// A damaged recording must give an error: HDF5 itself could loop forever, or read beyond its memory.
#include "app/recording/global_heap.h"

#include <gtest/gtest.h>

#include <cstring>

#include "app/recording/recording.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

constexpr std::array<std::uint64_t, 6> wrong{0, 1, 15, 1ULL << 20, 1ULL << 40, ~0ULL};

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

/// Offsets, in the content of a file, of the lengths of objects in a block of texts that begins at `begin`.
/// The last object is free space.
std::vector<std::size_t> lengths_in(const std::string& content, std::size_t begin) {
    std::uint64_t size = 0;
    std::memcpy(&size, content.data() + begin + 8, sizeof size);
    std::vector<std::size_t> places;
    for (std::size_t at = begin + 16; at + 16 <= begin + size;) {
        places.push_back(at + 8);
        std::uint64_t length = 0;
        std::memcpy(&length, content.data() + at + 8, sizeof length);
        at += content[at] == 0 && content[at + 1] == 0 ? length : 16 + (length + 7) / 8 * 8;
    }
    return places;
}

TEST(GlobalHeap, NoLengthOfATextLeadsAstray) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    const std::string whole = folder.contents().at(folder.path / "run.h5");
    const std::size_t begin = whole.find("GCOL");
    ASSERT_NE(begin, std::string::npos);
    EXPECT_NO_THROW(hdf5::require_sound_heap(bytes_of(whole.substr(begin))));
    const std::vector<std::size_t> places = lengths_in(whole, begin);
    ASSERT_GT(places.size(), 2U);
    for (const std::size_t place : places)
        for (const std::uint64_t length : wrong) {
            std::string damaged = whole;
            std::memcpy(damaged.data() + place, &length, sizeof length);
            folder.write("run.h5", damaged);
            try {
                const Recording recording(folder.path / "run.h5");
                EXPECT_FALSE(recording.end().empty());
            } catch (const Error& error) {
                EXPECT_NE(std::string(error.what()).find("run.h5"), std::string::npos) << error.what();
            }
        }
}

TEST(GlobalHeap, RefusesLengthsThatDoNotFit) {
    std::string block(4096, '\0');
    const auto put = [&](std::size_t place, std::uint64_t number) {
        std::memcpy(block.data() + place, &number, sizeof number);
    };
    std::memcpy(block.data(), "GCOL\1", 5);
    put(8, 4096);
    block[16] = 1;  // first text
    put(24, 20);    // length of the text, which takes 24 bytes and a header
    put(16 + 40 + 8, 4096 - 16 - 40);
    EXPECT_NO_THROW(hdf5::require_sound_heap(bytes_of(block)));
    for (const std::size_t place : {std::size_t{8}, std::size_t{24}, std::size_t{64}})
        for (const std::uint64_t length : wrong) {
            const std::string sound = block;
            put(place, length);
            // A shorter text may be followed by others, and a longer block extends beyond the bytes read.
            const bool may_be = (place == 24 && length <= 15) || (place == 8 && length == 1ULL << 20);
            if (!may_be) {
                EXPECT_THROW(hdf5::require_sound_heap(bytes_of(block)), Error) << place << " " << length;
            }
            block = sound;
        }
    EXPECT_NO_THROW(hdf5::require_sound_heap(bytes_of("no block of texts, which may hold anything")));
}

}  // namespace
}  // namespace sherd::test
