// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "app/descriptor.h"

namespace sherd {

namespace {

bool disk_is_full(int reason) {
    return reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
}

[[noreturn]] void no_room(const std::filesystem::path& file, std::size_t bytes, int reason) {
    throw Error(fmt::format("no room for {:.1f} MB more in '{}': {}; free some space or raise the limit",
                            1e-6 * static_cast<double>(bytes), file.string(), std::strerror(reason)),
                Fault::run);
}

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

PendingFile::PendingFile(const OutputLock& lock, Fault fault) : PendingFile(lock.output(), fault, lock) {}

PendingFile::PendingFile(std::filesystem::path target_, Fault fault, const OutputLock& whole)
    : target(std::move(target_)), temporary(target.string() + ".part") {
    if (target != whole.output()) own.emplace(target);
    const Descriptor created(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (created < 0) {
        const int reason = errno;
        throw Error(
            fmt::format("cannot create '{}': {}; name a file in a folder that exists and can be written",
                        target.string(), std::strerror(reason)),
            disk_is_full(reason) ? Fault::run : fault);
    }
}

PendingFile::~PendingFile() {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
}

void PendingFile::write(const std::string& text) {
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) no_room(target, text.size(), errno ? errno : ENOSPC);
}

void PendingFile::publish(bool replace) {
    const char* from = temporary.c_str();
    int result = ::renameat2(AT_FDCWD, from, AT_FDCWD, target.c_str(), replace ? 0 : RENAME_NOREPLACE);
    if (result != 0 && (errno == EINVAL || errno == ENOSYS)) {
        // A file system that cannot rename exclusively.
        check_free(target, replace);
        result = std::rename(from, target.c_str());
    }
    if (result != 0 && errno == EEXIST) check_free(target, replace);
    if (result != 0)
        throw Error(fmt::format("cannot create '{}': {}", target.string(), std::strerror(errno)), Fault::run);
}

void check_free(const std::filesystem::path& file, bool force) {
    const auto status = std::filesystem::status(file);
    if (!std::filesystem::exists(status)) return;
    if (!std::filesystem::is_regular_file(status))
        throw Error(fmt::format("'{}' exists and is not an ordinary file; name another one", file.string()));
    if (!force)
        throw Error(
            fmt::format("'{}' exists; name another file, or pass --force to replace it", file.string()));
}

void make_folder(const std::filesystem::path& folder) {
    if (folder.empty() || std::filesystem::is_directory(folder)) return;
    std::error_code reason;
    std::filesystem::create_directory(folder, reason);
    if (!std::filesystem::is_directory(folder))
        throw Error(fmt::format("cannot make the folder '{}': {}", folder.string(),
                                reason ? reason.message() : "something else has its name"));
}

DiskRoom::DiskRoom(std::filesystem::path file_, std::size_t bytes) : file(std::move(file_)) {
    const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    struct stat status {};
    if (opened < 0 || ::fstat(opened, &status) != 0)
        throw Error(fmt::format("cannot write to '{}': {}", file.string(), std::strerror(errno)), Fault::run);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    if (limit.rlim_cur != RLIM_INFINITY && static_cast<rlim_t>(status.st_size) + bytes > limit.rlim_cur)
        no_room(file, bytes, EFBIG);
    if (const int reason = reserve(opened, status.st_size, bytes)) {
        release(file);
        no_room(file, bytes, reason);
    }
}

DiskRoom::~DiskRoom() {
    release(file);
}

}  // namespace sherd
