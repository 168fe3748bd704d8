// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// Message on an invalid command line: the error, the nearest name to an unknown command or option, and a
/// reference to --help. Usable as CLI::App::failure_message().
std::string usage_message(const CLI::App* program, const CLI::Error& error);

}  // namespace sherd
