// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/files/byte_file.h"
#include "app/recording/hdf5.h"

/// Here HDF5 reads and writes the bytes of a ByteFile, by a virtual file driver. The file must outlive what
/// is opened in it; `name` is for messages. Functions throw Error (Fault::run).
namespace sherd::hdf5 {

enum class Access { create, read, write };
Handle open_in(ByteFile& file, const std::string& name, Access access);

}  // namespace sherd::hdf5
