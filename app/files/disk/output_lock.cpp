// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/output_lock.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>

#include "app/files/program_file.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_command = 200;  // characters in the lock file
constexpr const char* marker = "written by ";
constexpr auto pause = std::chrono::milliseconds(10);
constexpr int most_pauses = 100;  // longest wait until the owner of a lock has written its text

/// Replaces control characters, which a terminal would not show or would obey, by question marks.
std::string printable(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
    return text;
}

/// Returns the command line of this program.
std::string command_line() {
    std::string text = command_words();
    if (text.empty()) return "another program";
    text.pop_back();
    text.erase(0, text.substr(0, text.find('\0')).rfind('/') + 1);
    std::ranges::replace(text, '\0', ' ');
    if (text.size() > longest_command) text.replace(longest_command, std::string::npos, "...");
    return printable(text);
}

std::string host_name() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "this machine";
}

std::string introduction() {
    return fmt::format("{}'{}' (process {} on {}, since {:%F %T})\n", marker, command_line(), getpid(),
                       host_name(), fmt::localtime(std::time(nullptr)));
}

/// A lock file, and whether it has just been created.
struct LockFile {
    Descriptor descriptor;
    bool created;
};

/// Opens or creates `file`, the lock file of `output`. Returns no descriptor in the rare case that another
/// program removes the file between both attempts.
LockFile open_lock_file(const fs::path& file, const fs::path& output) {
    constexpr int flags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    Descriptor created(open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | flags, 0666));
    if (created >= 0) return {std::move(created), true};
    int reason = errno;
    if (reason == EEXIST) {
        Descriptor found(open(file.c_str(), O_RDWR | flags));
        if (found < 0 && errno == EACCES) found = Descriptor(open(file.c_str(), O_RDONLY | flags));
        if (found >= 0 || errno == ENOENT) return {std::move(found), false};
        reason = errno;
        throw Error(fmt::format("cannot open '{}', the lock of '{}': {}; remove it, or name another output",
                                file.string(), output.string(), std::strerror(reason)));
    }
    const bool full = reason == ENOSPC || reason == EDQUOT;
    throw Error(fmt::format("cannot create '{}': {}; name a file in a folder that exists and can be written",
                            output.string(), std::strerror(reason)),
                full ? Fault::run : Fault::input);
}

std::string text_of(const Descriptor& descriptor) {
    std::array<char, 1024> buffer;
    const ssize_t count = pread(descriptor, buffer.data(), buffer.size(), 0);
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

void write_introduction(const Descriptor& descriptor) {
    const std::string text = introduction();
    // On a full disk the lock file stays empty; the lock is held, but messages of other programs cannot name
    // this program.
    if (pwrite(descriptor, text.data(), text.size(), 0) < 0) return;
}

/// Whether the path still refers to the open file, which the last owner of the lock may have removed.
bool is_at(const Descriptor& descriptor, const fs::path& file) {
    struct stat opened {
    }, named{};
    return fstat(descriptor, &opened) == 0 && lstat(file.c_str(), &named) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

enum class Grip { held, busy, without_locks };

Grip try_lock(const Descriptor& descriptor, const fs::path& file) {
    if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return Grip::held;
    if (errno == EWOULDBLOCK) return Grip::busy;
    if (errno == ENOSYS || errno == EOPNOTSUPP || errno == ENOLCK) return Grip::without_locks;
    throw Error(fmt::format("cannot lock '{}': {}", file.string(), std::strerror(errno)), Fault::run);
}

[[noreturn]] void refuse(const fs::path& output, const std::string& text, const std::string& advice) {
    const std::string who = text.starts_with(marker) ? text.substr(0, text.find('\n')) : "written";
    throw Error(fmt::format("'{}' is being {}; wait for its end, end it, or name another output{}",
                            output.string(), printable(who), advice));
}

/// Removes the lock file of a program that was killed. text: content of the file. Throws Error (input) if the
/// removal fails, or if the text shows that the file is no lock file.
void remove_stale(const fs::path& file, const std::string& text) {
    std::error_code reason;
    if (text.starts_with(marker)) fs::remove(file, reason);
    if (!text.starts_with(marker) || reason)
        throw Error(
            fmt::format("'{}' is in the way{}; remove it, or name another output", file.string(),
                        reason ? " (" + reason.message() + ")" : ", and is not a lock of this program"));
}

}  // namespace

OutputLock::OutputLock(fs::path output) : target(std::move(output)), file(target.string() + ".lock") {
    for (int pauses = 0; !try_once(); ++pauses) {
        if (pauses == most_pauses) refuse(target, "", "");
        std::this_thread::sleep_for(pause);
    }
}

OutputLock::~OutputLock() {
    std::error_code ignored;
    if (held >= 0) fs::remove(file, ignored);
}

/// Tries once to take the lock, and returns whether it is taken. Returns false if another attempt may
/// succeed, and throws Error if not.
bool OutputLock::try_once() {
    LockFile lock = open_lock_file(file, target);
    if (lock.descriptor < 0) return false;
    const Grip grip = try_lock(lock.descriptor, file);
    const std::string text = text_of(lock.descriptor);
    if (grip == Grip::busy) {
        if (text.ends_with('\n')) refuse(target, text, "");
        return false;
    }
    if (grip == Grip::without_locks && !lock.created)
        refuse(target, text,
               fmt::format("; if it has ended, remove '{}': this file system has no locks", file.string()));
    if (!is_at(lock.descriptor, file)) return false;
    if (!text.empty()) {
        remove_stale(file, text);
        return false;
    }
    write_introduction(lock.descriptor);
    held = std::move(lock.descriptor);
    return true;
}

}  // namespace sherd
