// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "app/playback/slow_motion.h"

namespace sherd {

void add_slow_motion_option(CLI::App& command, std::optional<double>& factor);  ///< adds --slow

/// Adds --slow and --rate. rate_help: description of the rate.
void add_slow_motion_options(CLI::App& command, SlowMotion& motion, const char* rate_help);

}  // namespace sherd
