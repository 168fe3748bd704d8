// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/files/journaled_file.h"
#include "app/files/overlaid_file.h"
#include "app/files/pending_file.h"
#include "app/recording/hdf5.h"
#include "app/recording/hdf5_driver.h"

namespace sherd::hdf5 {

/// An HDF5 file that is open to be read, in its last committed state.
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

/// Fills a new HDF5 file. Throws Error (run) when there is no room for it.
void write_new(PendingFile& file, const std::function<void(hid_t)>& fill);

/// Changes an HDF5 file, as a whole or, when it throws Error (run), not at all.
void change(JournaledFile& file, const std::function<void(hid_t)>& edit);

}  // namespace sherd::hdf5
