// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace sherd {

/// Bytes as those of a file, wherever they are. Members throw Error (run).
class ByteFile {
  public:
    virtual ~ByteFile() = default;
    virtual std::uint64_t size() const = 0;
    /// What lies behind the end reads as zero.
    virtual void read(std::uint64_t offset, std::span<std::byte> bytes) const = 0;
    /// Makes the file longer where it is too short.
    virtual void write(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
    virtual void resize(std::uint64_t size) = 0;
};

}  // namespace sherd
