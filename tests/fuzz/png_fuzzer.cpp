// SPDX-License-Identifier: GPL-3.0-or-later
// Each input is read twice: unchanged, and with correct checksums of its blocks, since the reader refuses
// most inputs for wrong checksums.
#include <zlib.h>

#include "app/files/picture/image.h"
#include "tests/fuzz/read_input.h"

namespace {

/// Big-endian number of four bytes at a place of the file.
std::uint32_t number_at(const std::string& png, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<std::uint8_t>(png[at + i]);
    return number;
}

/// Corrects the checksums. A block is the length of its content, a word of four letters, the content, and a
/// checksum of the word and the content.
std::string with_checksums(std::string png) {
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = number_at(png, at), end = at + 8 + length;
        if (end + 4 > png.size()) break;
        const auto* word = reinterpret_cast<const Bytef*>(&png[at + 4]);
        const uLong sum = crc32(0, word, static_cast<uInt>(length + 4));
        for (std::size_t i = 0; i < 4; ++i) png[end + i] = static_cast<char>(sum >> (24 - 8 * i));
        at = end + 4;
    }
    return png;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    const std::string png = text_of(data, size);
    for (const std::string& bytes : {png, with_checksums(png)}) {
        const auto file = fuzz_folder().write("a.png", bytes);
        read_or_refuse([&] { sherd::read_picture(file); });
    }
    return 0;
}
