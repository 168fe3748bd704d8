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
    /// Waits for a writer to finish. Throws Error: (input) when the file is missing, damaged or not HDF5,
    /// (run) when another program has locked it.
    explicit ReadableFile(const std::filesystem::path& file);
    operator hid_t() const { return opened.file; }

  private:
    std::unique_ptr<OverlaidFile> bytes;
    OpenedFile opened;
};

/// Fills a new HDF5 file. Throws Error (run) if the disk is full.
void write_new(PendingFile& file, const std::function<void(hid_t)>& fill);

/// Changes an HDF5 file completely, or not at all if `edit` or the file throws Error.
void change(JournaledFile& file, const std::function<void(hid_t)>& edit);

}  // namespace sherd::hdf5
