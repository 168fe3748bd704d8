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
    double seconds = 0;  ///< s, processor time
    std::vector<ShellResult> results;
    std::string failure;  ///< why the run ended early, so that results are missing; empty: it is complete

    double largest_error() const;  ///< %, largest magnitude of the errors of all results
};

/// Computes a case; the first step that cannot be solved ends the run.
ShellRun run_case(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
