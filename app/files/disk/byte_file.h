// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace sherd {

/// Random access to the bytes of a file, on disk or in memory. Members throw Error (run) if an access fails.
class ByteFile {
  public:
    virtual ~ByteFile() = default;
    virtual std::uint64_t size() const = 0;
    /// Bytes beyond the end read as zero.
    virtual void read(std::uint64_t offset, std::span<std::byte> bytes) const = 0;
    /// Extends the file if the bytes reach beyond its end.
    virtual void write(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
    virtual void resize(std::uint64_t size) = 0;
};

}  // namespace sherd
