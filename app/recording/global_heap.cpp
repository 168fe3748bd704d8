// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/global_heap.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "meshops/error.h"

namespace sherd::hdf5 {
namespace {

constexpr std::string_view signature = "GCOL";
constexpr std::size_t head = 16;             // bytes, header of a collection or of an object in it
constexpr std::uint64_t longest = 1U << 30;  // bytes, longest collection; prevents overflow

template <class T>
T number_at(std::span<const std::byte> block, std::size_t place) {
    T number = 0;
    std::memcpy(&number, block.data() + place, sizeof number);
    return number;
}

}  // namespace

void require_sound_heap(std::span<const std::byte> block) {
    if (block.size() < head || std::memcmp(block.data(), signature.data(), signature.size()) != 0) return;
    const auto refuse = [] { throw Error("a block of texts is damaged"); };
    const auto size = number_at<std::uint64_t>(block, 8);
    if (size < head || size > longest) refuse();
    const std::size_t known = std::min<std::size_t>(size, block.size());
    for (std::size_t place = head; place + head <= known;) {
        const bool is_free = number_at<std::uint16_t>(block, place) == 0;
        const auto length = number_at<std::uint64_t>(block, place + 8);
        if (length > longest) refuse();
        const std::uint64_t whole = is_free ? length : head + (length + 7) / 8 * 8;
        if (whole < head || whole > size - place) refuse();
        place += whole;
    }
}

}  // namespace sherd::hdf5
