// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/state_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>

#include "meshops/error.h"

namespace sherd {

std::uint32_t state_sum(std::span<const char> text, std::uint32_t sum) {
    return static_cast<std::uint32_t>(
        ::crc32_z(sum, reinterpret_cast<const unsigned char*>(text.data()), text.size()));
}

void StateWriter::bytes(void* data, std::size_t size) {
    if (size == 0) return;  // `data` may be null, for which zlib returns the initial checksum
    const auto* text = static_cast<const char*>(data);
    out.write(text, static_cast<std::streamsize>(size));
    summed = state_sum({text, size}, summed);
    written += size;
}

void StateWriter::enter(const char* type) {
    const std::string_view name(type, std::strlen(type) + 1);
    out << name;
    summed = state_sum(name, summed);
    written += name.size();
}

void StateReader::bytes(void* data, std::size_t size) {
    if (size > rest.size())
        throw Error(fmt::format("the state ends {} bytes too early", size - rest.size()), Fault::run);
    if (size > 0) std::memcpy(data, rest.data(), size);
    rest = rest.subspan(size);
}

void StateReader::enter(const char* type) {
    const std::size_t size = std::strlen(type) + 1;
    if (size > rest.size() || std::memcmp(rest.data(), type, size) != 0)
        throw Error(
            fmt::format("the state belongs to another program: {} is missing where it should be", type),
            Fault::run);
    rest = rest.subspan(size);
}

void StateReader::finish() const {
    if (!rest.empty())
        throw Error(fmt::format("the state belongs to another program: {} bytes are left over", rest.size()),
                    Fault::run);
}

}  // namespace sherd
