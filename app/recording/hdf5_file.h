// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/files/disk/journaled_file.h"
#include "app/files/disk/overlaid_file.h"
#include "app/files/disk/pending_file.h"
#include "app/recording/hdf5.h"
#include "app/recording/hdf5_driver.h"

namespace sherd::hdf5 {

/// An HDF5 file that is open for reading, in its last committed state.
class ReadableFile {
  public:
    /// Opens the file, after waiting for a writer that has locked it. Throws Error (input) if the file is
    /// missing, damaged or not HDF5, Error (run) if another program keeps it locked.
    explicit ReadableFile(const std::filesystem::path& file);
    operator hid_t() const { return opened.file; }

  private:
    std::unique_ptr<OverlaidFile> bytes;
    OpenedFile opened;
};

/// Creates an HDF5 file by `fill`, and writes it into `file`. Throws Error (run) if the disk is full.
void write_new(PendingFile& file, const std::function<void(hid_t)>& fill);

/// Changes an HDF5 file by `edit`, and commits the change. If `edit` or writing throws Error, passes it on
/// and leaves the file unchanged.
void change(JournaledFile& file, const std::function<void(hid_t)>& edit);

}  // namespace sherd::hdf5
