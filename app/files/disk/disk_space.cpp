// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/disk_space.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "meshops/error.h"

namespace sherd {
namespace {

/// Returns a number of bytes with the largest unit that it reaches: "512 B", "4.1 kB", "37.0 MB".
std::string size_text(std::size_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    constexpr std::array units = {"kB", "MB", "GB"};
    double size = 1e-3 * static_cast<double>(bytes);
    std::size_t unit = 0;
    for (; size >= 1000 && unit + 1 < units.size(); ++unit) size *= 1e-3;
    return fmt::format("{:.1f} {}", size, units[unit]);
}

}  // namespace

bool disk_is_full(int reason) {
    return reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

void throw_no_space(const std::filesystem::path& file, std::size_t bytes, int reason) {
    const std::string size = bytes > 0 ? size_text(bytes) + " " : "";
    throw Error(fmt::format("no room for {}more in '{}': {}; free some space or raise the limit", size,
                            file.string(), std::strerror(reason)),
                Fault::run);
}

}  // namespace sherd
