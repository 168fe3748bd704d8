// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/state_archive.h"

#include <fmt/format.h>

#include <cstring>

#include "meshops/error.h"

namespace sherd {

void StateWriter::enter(const char* type) {
    text.append(type, std::strlen(type) + 1);
}

void StateSize::enter(const char* type) {
    count += std::strlen(type) + 1;
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
        throw Error(fmt::format("the state is of another program: no {} is where one should be", type),
                    Fault::run);
    rest = rest.subspan(size);
}

void StateReader::finish() const {
    if (!rest.empty())
        throw Error(fmt::format("the state is of another program: {} bytes are left over", rest.size()),
                    Fault::run);
}

}  // namespace sherd
