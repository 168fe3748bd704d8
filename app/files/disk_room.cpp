// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk_room.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <cerrno>
#include <cstring>

#include "app/files/descriptor.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// 0, or the error number that says why the space is not to be had.
int reserve(int descriptor, off_t size, std::size_t bytes) {
    int result;
    do result = ::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, size, static_cast<off_t>(bytes));
    while (result != 0 && errno == EINTR);
    if (result == 0) return 0;
    if (errno != EOPNOTSUPP && errno != ENOSYS) return errno;
    struct statvfs disk {};
    if (::fstatvfs(descriptor, &disk) != 0) return errno;
    return static_cast<std::size_t>(disk.f_bavail) * disk.f_frsize < bytes ? ENOSPC : 0;
}

/// Gives back what is reserved behind the end of the file.
void release(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file, ignored);
    if (!ignored) std::filesystem::resize_file(file, size, ignored);
}

}  // namespace

bool disk_is_full(int reason) {
    return reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

void refuse_room(const std::filesystem::path& file, std::size_t bytes, int reason) {
    throw Error(fmt::format("no room for {:.1f} MB more in '{}': {}; free some space or raise the limit",
                            1e-6 * static_cast<double>(bytes), file.string(), std::strerror(reason)),
                Fault::run);
}

DiskRoom::DiskRoom(std::filesystem::path file_, std::size_t bytes) : file(std::move(file_)) {
    const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    struct stat status {};
    if (opened < 0 || ::fstat(opened, &status) != 0)
        throw Error(fmt::format("cannot write to '{}': {}", file.string(), std::strerror(errno)), Fault::run);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    if (limit.rlim_cur != RLIM_INFINITY && static_cast<rlim_t>(status.st_size) + bytes > limit.rlim_cur)
        refuse_room(file, bytes, EFBIG);
    if (const int reason = reserve(opened, status.st_size, bytes)) {
        release(file);
        refuse_room(file, bytes, reason);
    }
}

DiskRoom::~DiskRoom() {
    release(file);
}

}  // namespace sherd
