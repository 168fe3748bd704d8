// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// How HDF5 tells what went wrong.
namespace sherd::hdf5 {

/// HDF5 prints its error stack unless told not to; ours goes into the Error.
void be_quiet();

/// Throws Error (run): `what`, and why the last call of HDF5 failed.
[[noreturn]] void fail(const std::string& what);

/// What a call of HDF5 has returned; a negative one is a failure.
template <class Result>
Result checked(Result result, const std::string& what) {
    if (result < 0) fail(what);
    return result;
}

}  // namespace sherd::hdf5
