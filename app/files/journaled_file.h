// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/files/byte_file.h"
#include "app/files/journal.h"

namespace sherd {

/// A file of which each change is there as a whole or not at all, whatever ends the program or the machine:
/// what changes stays in memory until commit(). New bytes go behind the end of the file, where nobody looks
/// for them yet; then the blocks that become others, and the new end, go into a journal beside it, which is
/// what commits the change; then they go into the file itself.
///
/// That last part waits for those who have the file open to read it, for `longest_wait` at most, and delays
/// nobody meanwhile: OverlaidFile reads the journal, too. One object at a time may have the file, and who
/// makes it holds its OutputLock.
class JournaledFile : public ByteFile {
  public:
    /// Opens a file, and mends it first. Throws Error (run).
    explicit JournaledFile(std::filesystem::path file,
                           std::chrono::milliseconds longest_wait = std::chrono::seconds(10));
    /// Forgets what has not been committed, and removes the journal if the file does not need it.
    ~JournaledFile() override;
    JournaledFile(const JournaledFile&) = delete;
    JournaledFile& operator=(const JournaledFile&) = delete;

    const std::filesystem::path& path() const { return disk.path(); }

    /// Throws Error (run) when the file has been removed, replaced or changed by another program, or is being
    /// written by one; and after an error of the disk.
    void require_undisturbed() const;

    // As changed until now, committed or not.
    std::uint64_t size() const override { return end; }
    void read(std::uint64_t offset, std::span<std::byte> bytes) const override;
    void write(std::uint64_t offset, std::span<const std::byte> bytes) override;
    void resize(std::uint64_t size) override;

    /// Makes the changes since the last commit last. Throws Error (run) when it cannot be done, without room
    /// for example, or when another program writes the file; then there are no changes since the last commit.
    /// After an error of the disk all later ones fail, too.
    void commit();
    /// Forgets what has been changed since the last commit.
    void roll_back();

  private:
    Block block(std::uint64_t number) const;
    bool is_applied() const;
    /// Puts the changes on the disk, behind the end and into the journal.
    void store();
    void apply_unless_read();
    void apply_now();
    /// Where the action throws, what is on the disk is not known any more.
    template <class Action>
    void or_fail(Action action);

    DiskFile disk;
    std::chrono::milliseconds longest_wait;
    std::uint64_t stored = 0;     ///< bytes on the disk, which may be needed
    std::uint64_t committed = 0;  ///< size, as committed
    std::uint64_t end = 0;        ///< size
    Blocks waiting;               ///< committed, not in the file yet
    Blocks changed;               ///< not committed
    std::vector<std::byte> tail;  ///< behind `stored`, not committed
    bool failed = false;          ///< what is on the disk is not known any more
    std::optional<std::chrono::steady_clock::time_point> waits_since;
};

}  // namespace sherd
