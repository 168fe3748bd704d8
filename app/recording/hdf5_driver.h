// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/files/byte_file.h"
#include "app/recording/hdf5.h"

/// Here HDF5 reads and writes the bytes of a ByteFile, by a virtual file driver. The file must outlive what
/// is opened in it; `name` is for messages. Functions throw Error (Fault::run).
namespace sherd::hdf5 {

enum class Access { create, read, write };

/// A file that is open, and its driver. HDF5 closes the file by what belongs to the driver, which it frees
/// with the last handle of it, even if that is the file's own (H5FD_close in 1.10.8): ours has to live
/// longer.
struct OpenedFile {
    Handle driver, file;
};

OpenedFile open_in(ByteFile& file, const std::string& name, Access access);

}  // namespace sherd::hdf5
