// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// Returns the manual page sherd(1) in roff with the macros of man(7): the help of `program` and of each of
/// its commands.
std::string manual_page(const CLI::App& program);

}  // namespace sherd
