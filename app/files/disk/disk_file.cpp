// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/disk_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "app/files/disk/disk_space.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr auto pause_between_tries = std::chrono::milliseconds(5);

}  // namespace

DiskFile::DiskFile(std::filesystem::path file_, int flags)
    : file(std::move(file_)), opened(::open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (opened >= 0) return;
    if (disk_is_full(errno)) throw_no_space(file, 0, errno);
    fail("open");
}

void DiskFile::fail(const char* what) const {
    const int reason = errno;
    throw Error(fmt::format("cannot {} '{}': {}", what, file.string(), std::strerror(reason)), Fault::run);
}

std::uint64_t DiskFile::size() const {
    struct stat status {};
    if (::fstat(opened, &status) != 0) fail("look at");
    return static_cast<std::uint64_t>(status.st_size);
}

void DiskFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::pread(opened, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail("read");
        if (count == 0) break;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
    std::ranges::fill(bytes, std::byte{0});
}

void DiskFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::pwrite(opened, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0 && disk_is_full(count == 0 ? ENOSPC : errno))
            throw_no_space(file, bytes.size(), count == 0 ? ENOSPC : errno);
        if (count < 0) fail("write to");
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

void DiskFile::resize(std::uint64_t size) {
    if (::ftruncate(opened, static_cast<off_t>(size)) != 0) fail("change the size of");
}

void DiskFile::sync() {
    if (::fdatasync(opened) != 0) fail("write to");
}

bool DiskFile::is_in_place() const {
    struct stat ours {
    }, named{};
    return ::fstat(opened, &ours) == 0 && ::stat(file.c_str(), &named) == 0 && ours.st_dev == named.st_dev &&
           ours.st_ino == named.st_ino;
}

bool DiskFile::lock(int kind, std::chrono::milliseconds patience) const {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (::flock(opened, kind | LOCK_NB) != 0) {
        if (errno == ENOSYS || errno == EOPNOTSUPP || errno == ENOLCK) return true;
        if (errno != EWOULDBLOCK && errno != EINTR) fail("lock");
        if (std::chrono::steady_clock::now() >= deadline) return false;
        std::this_thread::sleep_for(pause_between_tries);
    }
    return true;
}

bool DiskFile::lock_shared(std::chrono::milliseconds patience) const {
    return lock(LOCK_SH, patience);
}

bool DiskFile::lock_exclusive(std::chrono::milliseconds patience) const {
    return lock(LOCK_EX, patience);
}

void DiskFile::unlock() const {
    ::flock(opened, LOCK_UN);
}

void sync_folder_of(const std::filesystem::path& file) {
    std::filesystem::path folder = file.parent_path();
    if (folder.empty()) folder = ".";
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened >= 0 && ::fsync(opened) == 0) return;
    if (errno == EINVAL || errno == EACCES) return;  // the file system or the folder does not allow fsync()
    throw Error(fmt::format("cannot write to the folder '{}': {}", folder.string(), std::strerror(errno)),
                Fault::run);
}

}  // namespace sherd
