// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

/// Functions that turn errors of HDF5 into exceptions.
namespace sherd::hdf5 {

/// Stops HDF5 from printing its error stack; fail() puts the innermost error into the Error.
void silence_errors();

/// Throws Error (run) with the message `what` and the reason why the last call of HDF5 failed.
[[noreturn]] void fail(const std::string& what);

/// Returns the result of an HDF5 call; throws Error (run) if it is negative.
template <class Result>
Result checked(Result result, const std::string& what) {
    if (result < 0) fail(what);
    return result;
}

}  // namespace sherd::hdf5
