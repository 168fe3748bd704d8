// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

namespace sherd {

/// An open file descriptor, closed at the end of its scope.
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
    int number;  ///< negative: not open
};

/// An open file on disk. Members throw Error (run) with its name and the reason.
class DiskFile {
  public:
    /// flags: those of open(2).
    DiskFile(std::filesystem::path file, int flags);

    std::uint64_t size() const;
    /// Bytes beyond the end read as zero.
    void read(std::uint64_t offset, std::span<std::byte> bytes) const;
    void write(std::uint64_t offset, std::span<const std::byte> bytes);
    void resize(std::uint64_t size);
    /// Returns when the content is on the disk.
    void sync();
    /// Whether the path still refers to this file.
    bool is_in_place() const;

    /// Locks the file as HDF5 does, until it is closed or unlock(): shared by readers, exclusive for a
    /// writer. Returns false if others hold the lock, also after `patience`; true if the file system has no
    /// locks.
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

/// Returns when the directory entries of the file's folder are on the disk. Throws Error (run).
void sync_folder_of(const std::filesystem::path& file);

}  // namespace sherd
