// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/overlaid_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>

#include "meshops/error.h"

namespace sherd {

OverlaidFile::OverlaidFile(const std::filesystem::path& file, std::chrono::milliseconds patience)
    : disk(file, O_RDONLY) {
    if (!disk.lock_shared(patience))
        throw Error(
            fmt::format("'{}' is locked by a program that writes to it; try again later", file.string()),
            Fault::run);
    journal = read_journal(disk);
}

std::uint64_t OverlaidFile::size() const {
    return journal ? journal->end : disk.size();
}

void OverlaidFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    const std::uint64_t left = size() - std::min(size(), offset);
    std::ranges::fill(bytes.subspan(std::min<std::uint64_t>(left, bytes.size())), std::byte{0});
    bytes = bytes.first(std::min<std::uint64_t>(left, bytes.size()));
    disk.read(offset, bytes);
    if (journal) overlay(journal->blocks, offset, bytes);
}

void OverlaidFile::write(std::uint64_t, std::span<const std::byte>) {
    throw Error(fmt::format("'{}' is only read", disk.path().string()), Fault::run);
}

void OverlaidFile::resize(std::uint64_t) {
    throw Error(fmt::format("'{}' is only read", disk.path().string()), Fault::run);
}

}  // namespace sherd
