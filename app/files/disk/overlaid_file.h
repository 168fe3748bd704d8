// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/files/disk/byte_file.h"
#include "app/files/disk/journal.h"

namespace sherd {

/// Last committed state of a file that another program may be writing, or has left in the middle of a change:
/// the content on the disk, overlaid with the journal. The state does not change during the lifetime of this
/// object, unless the object lives longer than a writer waits for readers (`longest_wait` of JournaledFile).
class OverlaidFile : public ByteFile {
  public:
    /// Opens the file, and waits up to `patience` while a writer has locked it. Throws Error (run) if the
    /// file is still locked then, or cannot be opened or read.
    OverlaidFile(const std::filesystem::path& file, std::chrono::milliseconds patience);

    std::uint64_t size() const override;
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override;
    /// write() and resize() throw Error (run), since the file is read-only.
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

  private:
    DiskFile disk;
    std::optional<Journal> journal;
};

}  // namespace sherd
