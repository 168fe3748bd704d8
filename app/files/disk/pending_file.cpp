// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/pending_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "app/files/disk/disk_file.h"
#include "app/files/disk/disk_space.h"
#include "meshops/read_write/text_line.h"

namespace sherd {

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

void PendingFile::write(const std::function<void(std::ostream&)>& fill, std::size_t size) {
    std::ofstream out(temporary, std::ios::binary);
    fill(out);
    out.close();
    if (!out) throw_no_space(target, size, errno ? errno : ENOSPC);
}

void PendingFile::write(std::initializer_list<std::string_view> parts) {
    std::size_t size = 0;
    for (const std::string_view part : parts) size += part.size();
    write([&](std::ostream& out) { std::ranges::copy(parts, std::ostream_iterator<std::string_view>(out)); },
          size);
}

void PendingFile::publish(bool replace) {
    const char* from = temporary.c_str();
    int result = ::renameat2(AT_FDCWD, from, AT_FDCWD, target.c_str(), replace ? 0 : RENAME_NOREPLACE);
    if (result != 0 && (errno == EINVAL || errno == ENOSYS)) {
        // The file system has no exclusive renaming.
        check_free(target, replace);
        result = std::rename(from, target.c_str());
    }
    if (result != 0 && errno == EEXIST) check_free(target, replace);
    if (result != 0)
        throw Error(fmt::format("cannot create '{}': {}", target.string(), std::strerror(errno)), Fault::run);
}

void PendingFile::publish_durably() {
    DiskFile(temporary, O_RDONLY).sync();
    publish(true);
    sync_folder_of(target);
}

void check_free(const std::filesystem::path& file, bool force, const std::vector<std::filesystem::path>& read,
                std::string_view permission) {
    std::error_code unreadable;  // errors are reported when the file is created
    for (const std::filesystem::path& input : read)
        if (std::filesystem::equivalent(file, input, unreadable))
            throw Error(fmt::format("'{}' is read by this command and would be lost; name another file",
                                    file.string()));
    const auto status = std::filesystem::status(file, unreadable);
    if (!std::filesystem::exists(status)) return;
    if (!std::filesystem::is_regular_file(status))
        throw Error(fmt::format("'{}' exists and is not an ordinary file; name another one", file.string()));
    if (!force)
        throw Error(fmt::format("'{}' exists; name another file, or pass {} to replace it", file.string(),
                                permission));
}

void require_kind(const std::filesystem::path& file, std::string_view extension, std::string_view advice) {
    const std::string ending = lower_case(file.extension().string());
    for (const std::string_view kind :
         {".h5",  ".xdmf", ".obj",  ".ply", ".stl", ".off",  ".vtp",  ".pvd",  ".pc2",
          ".mdd", ".glb",  ".gltf", ".vdb", ".csv", ".json", ".svg",  ".pdf",  ".eps",
          ".png", ".jpg",  ".jpeg", ".gif", ".bmp", ".tif",  ".tiff", ".webp", ".ppm",
          ".exr", ".mp4",  ".m4v",  ".mov", ".avi", ".mkv",  ".webm", ".html", ".toml"})
        if (ending == kind && ending != extension)
            throw Error(fmt::format("-o {}: {}", file.string(), advice));
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code reason, unreadable;
    if (folder.empty() || std::filesystem::is_directory(folder, unreadable)) return;
    std::filesystem::create_directory(folder, reason);
    if (!std::filesystem::is_directory(folder, unreadable))
        throw Error(fmt::format("cannot make the folder '{}': {}", folder.string(),
                                reason ? reason.message() : "something else has its name"));
}

}  // namespace sherd
