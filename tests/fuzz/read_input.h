// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {

/// Folder of this fuzzer's files.
inline const TemporaryDirectory& fuzz_folder() {
    static const TemporaryDirectory folder;
    return folder;
}

/// Calls `read`. Error is the only exception that it may throw: any other one is a finding.
template <class Read>
void read_or_refuse(const Read& read) {
    try {
        read();
    } catch (const Error&) {
        return;
    }
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace sherd::test
