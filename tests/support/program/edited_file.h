// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <stdexcept>

#include "app/recording/hdf5.h"

namespace sherd::test {

/// Opens an HDF5 file to be changed as by another program: changes reach the file at once, and destroying the
/// handle closes it.
inline hdf5::Handle open_to_edit(const std::filesystem::path& file) {
    const hdf5::Handle access(H5Pcreate(H5P_FILE_ACCESS));
    H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
    hdf5::Handle opened(H5Fopen(file.c_str(), H5F_ACC_RDWR, access));
    if (opened < 0) throw std::runtime_error("cannot open " + file.string());
    return opened;
}

}  // namespace sherd::test
