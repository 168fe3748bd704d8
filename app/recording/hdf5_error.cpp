// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/hdf5_error.h"

#include <hdf5.h>

#include "meshops/error.h"

namespace sherd::hdf5 {
namespace {

herr_t keep_innermost(unsigned depth, const H5E_error2_t* entry, void* text) {
    if (depth == 0 && entry->desc) *static_cast<std::string*>(text) = entry->desc;
    return 0;
}

}  // namespace

void silence_errors() {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void fail(const std::string& what) {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
    throw Error(what + (reason.empty() ? "" : " (HDF5: " + reason + ")"), Fault::run);
}

}  // namespace sherd::hdf5
