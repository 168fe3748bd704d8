// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/disk_space.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "meshops/error.h"

namespace sherd {

bool disk_is_full(int reason) {
    return reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

void throw_no_space(const std::filesystem::path& file, std::size_t bytes, int reason) {
    const std::string size = bytes > 0 ? fmt::format("{:.1f} MB ", 1e-6 * static_cast<double>(bytes)) : "";
    throw Error(fmt::format("no room for {}more in '{}': {}; free some space or raise the limit", size,
                            file.string(), std::strerror(reason)),
                Fault::run);
}

}  // namespace sherd
