// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/files/byte_file.h"
#include "app/files/journal.h"

namespace sherd {

/// The last committed state of a file that another program may be writing, or has left in the middle of a
/// change: what is on the disk, with the journal over it. Stays that state as long as this lives, unless it
/// lives for longer than a writer waits for its readers (JournaledFile).
class OverlaidFile : public ByteFile {
  public:
    /// Waits up to `patience` for a writer that has locked the file. Throws Error (run).
    OverlaidFile(const std::filesystem::path& file, std::chrono::milliseconds patience);

    std::uint64_t size() const override;
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override;
    /// These two throw Error (run): it is only read.
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

  private:
    DiskFile disk;
    std::optional<Journal> journal;
};

}  // namespace sherd
