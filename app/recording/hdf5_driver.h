// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/files/disk/byte_file.h"
#include "app/recording/hdf5.h"

/// HDF5 files in a ByteFile, by a virtual file driver. The ByteFile must outlive all handles of the file;
/// `name` is for messages. Functions throw Error (Fault::run).
namespace sherd::hdf5 {

enum class Access { create, read, write };

/// An open file, and its driver. HDF5 frees a driver with the last handle of it, and still uses it after it
/// has released the file's own handle (H5FD_close in 1.10.8): `driver` must outlive `file`.
struct OpenedFile {
    Handle driver, file;
};

OpenedFile open_in(ByteFile& file, const std::string& name, Access access);

}  // namespace sherd::hdf5
