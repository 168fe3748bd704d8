// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/slow_motion_options.h"

namespace sherd {

void add_slow_motion_option(CLI::App& command, std::optional<double>& factor) {
    command
        .add_option(
            "--slow", factor,
            "How many times slower than reality; 1 is real time (default: such that it lasts 4 to 10 s)")
        ->option_text("FACTOR");
}

void add_slow_motion_options(CLI::App& command, SlowMotion& motion, const char* rate_help) {
    add_slow_motion_option(command, motion.factor);
    command.add_option("--rate", motion.rate, rate_help)->option_text("R");
}

}  // namespace sherd
