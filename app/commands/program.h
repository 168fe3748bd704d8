// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include "app/commands/commands.h"

namespace sherd {

/// Prepares the process for long runs: freed memory is kept, standard streams exist, and a closed pipe, a
/// file size limit and Ctrl-C do not end the process. Must be called first.
void prepare_process();

/// Parses the command line and runs the chosen command; prints errors and returns the exit code: 0 done, 1
/// failed, 2 bad input.
int run_program(CLI::App& program, const Command& chosen, int argc, char** argv);

}  // namespace sherd
