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

#include "app/files/output_lock.h"
#include "meshops/error.h"

namespace sherd {

/// A file that is written under another name (`NAME.part`) in the same folder until it is complete, and
/// removed if it never is.
class PendingFile {
  public:
    /// Creates it empty. The lock is that of the file and must outlive this. Throws Error of kind `fault`
    /// when it cannot be created.
    PendingFile(const OutputLock& lock, Fault fault);
    /// One file of an output of several, which as a whole is locked: the file gets its own lock, too. Throws
    /// Error (input) when another program has that.
    PendingFile(std::filesystem::path target, Fault fault, const OutputLock& whole);
    ~PendingFile();
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;

    const std::filesystem::path& path() const { return temporary; }
    /// Each replaces what was written before, and throws Error (run) when the disk is full. size: in bytes,
    /// for that message; 0: it is not known.
    void write(const std::function<void(std::ostream&)>& fill, std::size_t size = 0);
    void write(std::initializer_list<std::string_view> parts);
    void write(const std::string& text) { write({std::string_view(text)}); }
    /// Gives it its name. Throws Error (input) when that is taken and not `replace`.
    void publish(bool replace);
    /// Does so, replacing what has the name, when all of it is on the disk: a power cut leaves one or the
    /// other whole.
    void publish_durably();

  private:
    std::filesystem::path target, temporary;
    std::optional<OutputLock> own;
};

/// Throws Error (input) when `file` exists and not `force`, when it is no ordinary file, and when it is in
/// `read`, the files that the command reads: not even `force` may replace them.
void check_free(const std::filesystem::path& file, bool force,
                const std::vector<std::filesystem::path>& read = {});

/// Throws Error (input), with `advice` on what to name instead, when a command that writes files with this
/// `extension` was given a name that ends with that of another kind of file. Other endings are part of a
/// name, as in run_0.5.
void require_kind(const std::filesystem::path& file, std::string_view extension, std::string_view advice);

/// Makes a folder unless it is there; those above it must be there. Throws Error (input).
void make_folder(const std::filesystem::path& folder);

}  // namespace sherd
