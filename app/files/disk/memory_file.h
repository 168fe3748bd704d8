// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstring>
#include <string>

#include "app/files/disk/byte_file.h"

namespace sherd {

/// A file in memory.
class MemoryFile : public ByteFile {
  public:
    std::uint64_t size() const override { return content.size(); }
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override {
        std::ranges::fill(bytes, std::byte{0});
        if (offset < content.size())
            std::memcpy(bytes.data(), content.data() + offset,
                        std::min<std::uint64_t>(bytes.size(), content.size() - offset));
    }
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override {
        if (offset + bytes.size() > content.size()) resize(offset + bytes.size());
        std::memcpy(content.data() + offset, bytes.data(), bytes.size());
    }
    void resize(std::uint64_t size) override { content.resize(size); }

    const std::string& text() const { return content; }

  private:
    std::string content;
};

}  // namespace sherd
