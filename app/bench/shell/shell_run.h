// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/shell/shell_case.h"

namespace sherd {

struct ShellRun {
    std::size_t faces = 0;
    std::int64_t iterations = 0;
    double seconds = 0;  ///< processor time
    std::vector<ShellResult> results;
    std::string failure;  ///< why there are none, or too few; empty: all is well

    double largest_error() const;  ///< %, of all results, without sign
};

/// Computes a case; a step that cannot be solved ends it.
ShellRun run_case(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
