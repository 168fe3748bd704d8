// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/checksum.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "meshops/error.h"

namespace sherd {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw Error(fmt::format("cannot read '{}'", file.string()));
    return text;
}

std::uint64_t checksum_of(const std::filesystem::path& file) {
    return checksum(text_of(file));
}

}  // namespace sherd
