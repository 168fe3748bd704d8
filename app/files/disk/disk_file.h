// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace sherd {

/// Owner of a file descriptor, which is closed at the end of the owner's scope.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number(number) {}
    Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number, other.number);
        return *this;
    }
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
    operator int() const { return number; }

  private:
    int number;  ///< file descriptor; negative if none is open
};

/// An open file on disk. On failure members throw Error (run) with the file's name and the reason.
class DiskFile {
  public:
    /// Opens the file. flags: as for open(2).
    DiskFile(std::filesystem::path file, int flags);

    std::uint64_t size() const;
    /// Bytes beyond the end read as zero.
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void resize(std::uint64_t size);
    /// Writes the content to the disk; returns when it is there.
    void sync();
    /// Whether the path still refers to the open file.
    bool is_in_place() const;

    /// Both functions lock the file with flock(2), as HDF5 does, until unlock() or until the file is closed.
    /// Several readers can have the shared lock; a writer's exclusive lock excludes all other locks. The
    /// functions wait up to `patience` for other programs' locks, and return whether the file is locked; they
    /// return true, too, if the file system has no locks.
    bool lock_shared(std::chrono::milliseconds patience = {}) const;
    bool lock_exclusive(std::chrono::milliseconds patience = {}) const;
    void unlock() const;

    const std::filesystem::path& path() const { return file; }

  private:
    [[noreturn]] void fail(const char* what) const;
    bool lock(int kind, std::chrono::milliseconds patience) const;

    std::filesystem::path file;
    Descriptor opened;
};

/// Writes the directory entries of the file's folder to the disk, and returns when they are there. Does
/// nothing if the file system or the folder does not allow this. Throws Error (run) if writing fails.
void sync_folder_of(const std::filesystem::path& file);

}  // namespace sherd
