// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/disk/byte_file.h"
#include "app/files/disk/journal.h"

namespace sherd {

/// A file whose changes are stored as a whole or not at all, even if the program is killed or the power
/// fails. Changes stay in memory until commit(), which takes three steps. It writes new bytes behind the end
/// of the file, where no reader looks yet; then it writes the changed blocks and the new size into a journal
/// beside the file, which commits the change; then it writes the changed blocks into the file itself.
///
/// While other programs have the file open for reading, commit() leaves the last step to a later commit, for
/// `longest_wait` at most. Readers never wait for this step, since OverlaidFile reads the journal, too. Only
/// one object at a time may have the file, and its owner must hold the file's OutputLock.
class JournaledFile : public ByteFile {
  public:
    /// Opens a file; first applies a journal that was left beside it. Throws Error (run) if the file cannot
    /// be opened, read or written.
    explicit JournaledFile(std::filesystem::path file,
                           std::chrono::milliseconds longest_wait = std::chrono::seconds(10));
    /// Discards uncommitted changes, applies the journal and removes it. The journal stays after a disk
    /// error, or if another program has locked the file for writing.
    ~JournaledFile() override;
    JournaledFile(const JournaledFile&) = delete;
    JournaledFile& operator=(const JournaledFile&) = delete;

    const std::filesystem::path& path() const { return disk.path(); }

    /// Throws Error (run) if another program has removed, replaced or changed the file, or is writing it, or
    /// if a disk error has occurred before.
    void require_undisturbed() const;

    // Members of ByteFile; they see uncommitted changes, too.
    std::uint64_t size() const override { return end; }
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override;
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

    /// Commits the changes since the last commit. Throws Error (run) if they cannot be stored, for example on
    /// a full disk, or if another program writes the file; the changes are then discarded. After a disk error
    /// all later commits fail, too.
    void commit();
    /// Discards the changes since the last commit.
    void roll_back();

  private:
    Block block(std::uint64_t number) const;
    bool is_applied() const;
    /// Writes new bytes behind the end of the file, and changed blocks into the journal.
    void store();
    void apply_unless_read();
    void apply_now();
    /// Calls `action`; if that throws, `failed` stays set.
    template <class Action>
    void or_fail(Action action);

    DiskFile disk;
    std::chrono::milliseconds longest_wait;
    std::uint64_t stored = 0;     ///< bytes, size of the file on the disk
    std::uint64_t committed = 0;  ///< bytes, committed size of the file
    std::uint64_t end = 0;        ///< bytes, size of the file with uncommitted changes
    Blocks waiting;               ///< committed blocks that are not yet written into the file
    Blocks changed;               ///< uncommitted blocks
    std::vector<std::byte> tail;  ///< uncommitted bytes at and beyond the offset `stored`
    bool failed = false;          ///< whether a disk error has left the content on the disk unknown
    /// Time of the first commit that had to leave blocks waiting because of readers.
    std::optional<std::chrono::steady_clock::time_point> waits_since;
};

}  // namespace sherd
