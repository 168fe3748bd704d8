// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/program/system_calls.h"

#include <sys/stat.h>
#include <sys/types.h>

#include <cerrno>
#include <utility>

// Names required by the linker's --wrap.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
ssize_t __real_pwrite(int descriptor, const void* bytes, std::size_t size, off_t offset);
int __real_ftruncate(int descriptor, off_t size);
int __real_fdatasync(int descriptor);
int __real_fsync(int descriptor);
int __real_rename(const char* from, const char* to);
int __real_unlink(const char* file);
}

namespace sherd::test {
namespace {

SystemCalls* listener = nullptr;  // C calls have no other access to the object

std::filesystem::path name_of(int descriptor) {
    return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor));
}

/// Makes a call unless it must fail.
template <class Call>
auto told(const SystemCall& call, Call make) {
    if (listener != nullptr)
        if (const int reason = listener->note(call)) {
            errno = reason;
            return decltype(make())(-1);
        }
    return make();
}

}  // namespace

SystemCalls::SystemCalls(std::filesystem::path folder_) : folder(std::move(folder_)) {
    listener = this;
}

SystemCalls::~SystemCalls() {
    listener = nullptr;
}

int SystemCalls::note(SystemCall call) {
    if (call.file != folder && call.file.parent_path() != folder) return 0;
    const bool fails = failing && *failing == made.size();
    made.push_back(std::move(call));
    return fails ? reason : 0;
}

}  // namespace sherd::test

using sherd::test::SystemCall;

extern "C" {

ssize_t __wrap_pwrite(int descriptor, const void* bytes, std::size_t size, off_t offset) {
    const SystemCall call{.kind = SystemCall::Kind::write,
                          .file = sherd::test::name_of(descriptor),
                          .offset = static_cast<std::uint64_t>(offset),
                          .bytes = {static_cast<const char*>(bytes), size}};
    const ssize_t count =
        sherd::test::told(call, [&] { return __real_pwrite(descriptor, bytes, size, offset); });
    if (count < 0) {
        constexpr off_t sector = 512;  // bytes that a disk writes as a whole
        const int reason = errno;
        const off_t half = (offset + static_cast<off_t>(size / 2)) / sector * sector - offset;
        if (half > 0 && __real_pwrite(descriptor, bytes, static_cast<std::size_t>(half), offset) < 0)
            return -1;
        errno = reason;
    }
    return count;
}

int __wrap_ftruncate(int descriptor, off_t size) {
    return sherd::test::told({.kind = SystemCall::Kind::resize,
                              .file = sherd::test::name_of(descriptor),
                              .offset = static_cast<std::uint64_t>(size)},
                             [&] { return __real_ftruncate(descriptor, size); });
}

int __wrap_fdatasync(int descriptor) {
    return sherd::test::told({.kind = SystemCall::Kind::sync, .file = sherd::test::name_of(descriptor)},
                             [&] { return __real_fdatasync(descriptor); });
}

int __wrap_fsync(int descriptor) {
    return sherd::test::told(
        {.kind = SystemCall::Kind::sync_folder, .file = sherd::test::name_of(descriptor)},
        [&] { return __real_fsync(descriptor); });
}

int __wrap_rename(const char* from, const char* to) {
    return sherd::test::told({.kind = SystemCall::Kind::rename, .file = from, .target = to},
                             [&] { return __real_rename(from, to); });
}

int __wrap_unlink(const char* file) {
    return sherd::test::told({.kind = SystemCall::Kind::remove, .file = file},
                             [&] { return __real_unlink(file); });
}
}
// NOLINTEND(bugprone-reserved-identifier)
