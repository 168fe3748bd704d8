// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/disk/byte_file.h"
#include "app/files/disk/journal.h"

namespace sherd {

/// A file whose changes are stored as a whole or not at all, whatever ends the program or the machine.
/// Changes stay in memory until commit(), which writes new bytes behind the end of the file, where no reader
/// looks yet; then the changed blocks and the new end into a journal beside it, which commits the change;
/// then these into the file itself.
///
/// The last part waits for programs that have the file open for reading, for `longest_wait` at most. It
/// delays none of them, since OverlaidFile reads the journal, too. Only one object at a time may have the
/// file, and its owner must hold the file's OutputLock.
class JournaledFile : public ByteFile {
  public:
    /// Opens a file, and repairs it first. Throws Error (run).
    explicit JournaledFile(std::filesystem::path file,
                           std::chrono::milliseconds longest_wait = std::chrono::seconds(10));
    /// Discards uncommitted changes, and removes the journal if the file does not need it.
    ~JournaledFile() override;
    JournaledFile(const JournaledFile&) = delete;
    JournaledFile& operator=(const JournaledFile&) = delete;

    const std::filesystem::path& path() const { return disk.path(); }

    /// Throws Error (run) if another program has removed, replaced or changed the file, or is writing it; and
    /// after a disk error.
    void require_undisturbed() const;

    // Including uncommitted changes.
    std::uint64_t size() const override { return end; }
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override;
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

    /// Commits the changes since the last commit. Throws Error (run) if that fails, on a full disk for
    /// example, or if another program writes the file; the changes are then discarded. After a disk error all
    /// later commits fail, too.
    void commit();
    /// Discards the changes since the last commit.
    void roll_back();

  private:
    Block block(std::uint64_t number) const;
    bool is_applied() const;
    /// Writes the changes to the disk, behind the end and into the journal.
    void store();
    void apply_unless_read();
    void apply_now();
    /// Calls the action; `failed` stays set if it throws.
    template <class Action>
    void or_fail(Action action);

    DiskFile disk;
    std::chrono::milliseconds longest_wait;
    std::uint64_t stored = 0;     ///< bytes, size of the file on the disk
    std::uint64_t committed = 0;  ///< bytes, committed size
    std::uint64_t end = 0;        ///< bytes, size with uncommitted changes
    Blocks waiting;               ///< committed, not yet in the file
    Blocks changed;               ///< not committed
    std::vector<std::byte> tail;  ///< not committed, to be written behind `stored`
    bool failed = false;          ///< whether the content on the disk is unknown
    std::optional<std::chrono::steady_clock::time_point> waits_since;
};

}  // namespace sherd
