// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/checksum.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "meshops/error.h"

namespace sherd {

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
    if (!stream.is_open() || stream.bad() || !text)
        throw Error(fmt::format("cannot read '{}'", file.string()));
    return std::move(text).str();
}

std::uint64_t checksum_of(const std::filesystem::path& file) {
    return checksum(text_of(file));
}

}  // namespace sherd
