// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/files/disk/byte_file.h"
#include "app/recording/hdf5.h"

/// HDF5 files whose bytes are in a ByteFile, which a virtual file driver accesses. The ByteFile must outlive
/// all handles of the file; `name` is for messages. Functions throw Error (Fault::run) on failure.
namespace sherd::hdf5 {

enum class Access { create, read, write };

/// An open file, and its driver. HDF5 frees a driver when the last handle of the driver is released, but
/// still uses it after releasing the file's own handle of the driver (H5FD_close in 1.10.8). Therefore
/// `driver` must outlive `file`.
struct OpenedFile {
    Handle driver, file;
};

OpenedFile open_in(ByteFile& file, const std::string& name, Access access);

}  // namespace sherd::hdf5
