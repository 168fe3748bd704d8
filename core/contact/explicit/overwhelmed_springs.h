// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace sherd {

/// Springs of explicit contact have let something pass through something. The step is not made; implicit ones
/// may hold it.
struct OverwhelmedSprings : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace sherd
