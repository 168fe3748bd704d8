// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// How a run ended.
struct RunEnd {
    std::string how;          ///< "complete", "interrupted" or "failed: ..."
    double wall_seconds = 0;  ///< s, from its first step on

    bool is_complete() const { return how == "complete"; }
    bool has_failed() const { return how.starts_with("failed"); }
};

}  // namespace sherd
