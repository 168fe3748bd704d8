// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/disk/output_lock.h"
#include "meshops/error.h"

namespace sherd {

/// A file that is written under another name (`NAME.part`) in the same folder until it is complete, and
/// removed if it never is.
class PendingFile {
  public:
    /// Creates an empty file. lock: lock of the output that the file is to become; it must outlive this
    /// object. Throws Error of kind `fault` if the file cannot be created, and Error (run) if the disk is
    /// full.
    PendingFile(const OutputLock& lock, Fault fault);
    /// Creates an empty file that is to become `target`, one of several files of an output. whole: lock of
    /// the output. If `target` is not the output itself, this object also takes a lock of `target`; throws
    /// Error (input) if another program holds that lock. Throws as the first constructor if the file cannot
    /// be created.
    PendingFile(std::filesystem::path target, Fault fault, const OutputLock& whole);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& path() const { return temporary; }
    /// Replaces the content by what `fill` writes. Throws Error (run) if the disk is full. size: number of
    /// bytes for the message of this error; 0 if unknown.
    void write(const std::function<void(std::ostream&)>& fill, std::size_t size = 0);
    void write(std::initializer_list<std::string_view> parts);
    void write(const std::string& text) { write({std::string_view(text)}); }
    /// Renames the file to its target. Throws Error (input) if the target exists and `replace` is false,
    /// Error (run) if renaming fails.
    void publish(bool replace);
    /// Writes the content to the disk and then replaces the target, so that a power cut leaves either the old
    /// or the new file, complete.
    void publish_durably();

  private:
    std::filesystem::path target, temporary;
    std::optional<OutputLock> own;  ///< lock of `target`, unless `target` is the output itself
};

/// Throws Error (input) if `file` exists and `force` is false. Even if `force` is true, throws if `file`
/// exists and is no ordinary file, or is one of `read`, the files that the command reads. permission: what
/// sets `force`, for the message.
void check_free(const std::filesystem::path& file, bool force,
                const std::vector<std::filesystem::path>& read = {}, std::string_view permission = "--force");

/// The user has named `file` as output of a command that writes files with this `extension`. Throws Error
/// (input) with `advice`, which says what to name instead, if `file` ends with the extension of another known
/// kind of file. Other endings are part of the name, for example in run_0.5.
void require_kind(const std::filesystem::path& file, std::string_view extension, std::string_view advice);

/// Creates a folder unless it exists; its parent must exist. Throws Error (input) if the folder cannot be
/// created.
void make_folder(const std::filesystem::path& folder);

}  // namespace sherd
