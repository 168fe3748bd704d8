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
    /// Creates an empty file. lock: that of the file, which must outlive this object. Throws Error of kind
    /// `fault` if it cannot be created.
    PendingFile(const OutputLock& lock, Fault fault);
    /// Creates one of several files of an output whose lock is `whole`; the file gets its own lock, too.
    /// Throws Error (input) if another program holds that.
    PendingFile(std::filesystem::path target, Fault fault, const OutputLock& whole);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& path() const { return temporary; }
    /// Replaces the content. Throws Error (run) if the disk is full. size: bytes, for that message; 0:
    /// unknown.
    void write(const std::function<void(std::ostream&)>& fill, std::size_t size = 0);
    void write(std::initializer_list<std::string_view> parts);
    void write(const std::string& text) { write({std::string_view(text)}); }
    /// Renames the file to its target. Throws Error (input) if that exists and `replace` is false.
    void publish(bool replace);
    /// Replaces the target when the content is on the disk: a power cut leaves the old or the new file
    /// complete.
    void publish_durably();

  private:
    std::filesystem::path target, temporary;
    std::optional<OutputLock> own;
};

/// Throws Error (input) if `file` exists and `force` is false, if it is no ordinary file, or if it is in
/// `read`, the files that the command reads: not even `force` may replace them.
void check_free(const std::filesystem::path& file, bool force,
                const std::vector<std::filesystem::path>& read = {});

/// Throws Error (input), with `advice` on what to name instead, when a command that writes files with this
/// `extension` was given a name that ends with that of another kind of file. Other endings are part of a
/// name, as in run_0.5.
void require_kind(const std::filesystem::path& file, std::string_view extension, std::string_view advice);

/// Creates a folder unless it exists; its parent must exist. Throws Error (input).
void make_folder(const std::filesystem::path& folder);

}  // namespace sherd
