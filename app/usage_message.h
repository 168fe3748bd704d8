// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// What to print when the command line cannot be understood: what is wrong with it, with the nearest name of
/// a command or option that is not known, and where to read more. A CLI::FailureMessage.
std::string usage_message(const CLI::App* program, const CLI::Error& error);

}  // namespace sherd
