// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "meshops/error.h"

namespace sherd::test {

/// Returns the message of the Error that `work` throws; "no error" if there is none.
template <class Work>
std::string message_thrown_by(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace sherd::test
