// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// The manual page sherd(1) in roff (macros of man): the help of `program` and of each of its commands.
std::string manual_page(const CLI::App& program);

}  // namespace sherd
