// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <zlib.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/program/base64.h"
#include "tests/support/recording/export_fixture.h"

namespace sherd::test {

/// Reads the numbers of an array in the text of a .vtp file: block sizes in base64, followed by zlib blocks
/// in base64.
template <class T>
std::vector<T> vtp_array(const std::string& vtp, const std::string& type, const std::string& name) {
    const std::size_t tag = vtp.find("<DataArray type=\"" + type + "\" Name=\"" + name + "\"");
    if (tag == std::string::npos) throw std::out_of_range("no " + type + " " + name);
    const std::size_t begin = vtp.find(">\n", tag) + 2, end = vtp.find("\n</DataArray>", tag);
    const std::string text = vtp.substr(begin, end - begin);
    const auto blocks = Bytes(from_base64(text.substr(0, 12))).next<std::uint64_t>();
    const std::size_t head_length = (8 * (3 + blocks) + 2) / 3 * 4;
    Bytes head(from_base64(text.substr(0, head_length)), 8), data(from_base64(text.substr(head_length)));
    const auto whole = head.next<std::uint64_t>(), last = head.next<std::uint64_t>();
    std::vector<T> numbers;
    for (std::size_t i = 0; i < blocks; ++i) {
        const std::string block = data.text(head.next<std::uint64_t>());
        uLongf size = i + 1 == blocks && last > 0 ? last : whole;
        std::vector<T> part(size / sizeof(T));
        EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(part.data()), &size,
                             reinterpret_cast<const Bytef*>(block.data()), block.size()),
                  Z_OK);
        EXPECT_EQ(size, part.size() * sizeof(T));
        numbers.insert(numbers.end(), part.begin(), part.end());
    }
    EXPECT_TRUE(head.at_end() && data.at_end()) << name;
    return numbers;
}

}  // namespace sherd::test
