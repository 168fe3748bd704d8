// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/bench/shell_case.h"

namespace sherd {

/// A computed number beside its reference.
struct ShellResult {
    std::string name;  ///< "W_A at 0.5"
    double value = 0, reference = 0;

    double error() const { return 100 * (value / reference - 1); }  ///< %
};

struct ShellRun {
    std::size_t faces = 0;
    std::int64_t iterations = 0;
    double seconds = 0;  ///< of wall time
    std::vector<ShellResult> results;
    std::string failure;  ///< why there are none, or too few; empty: all is well
};

/// Computes a case; a step that cannot be solved ends it.
ShellRun run_case(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
