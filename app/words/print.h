// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sherd {

/// Writes a text whole, or not: no exception tells of a failure, which stays in the stream's error flag.
void put_text(std::FILE* stream, std::string_view text);

/// Writes to stdout. A failure does not end the work: main() turns it into exit code 1 at the end.
template <class... Arguments>
void print_result(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    put_text(stdout, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Writes to stderr, behind all that stdout has been given. Nothing depends on it: a terminal that has gone
/// or a log on a full disk ends no run.
template <class... Arguments>
void print_message(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::fflush(stdout);
    put_text(stderr, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// A message for each.
void print_warnings(const std::vector<std::string>& warnings);

/// Ends the program by SIGPIPE, silently, as programs end whose reader has gone; returns if the signal is
/// blocked.
void end_without_reader();

/// Writes what stdout still holds; returns whether all that was printed is written. Does not return if its
/// reader has gone, as that of `sherd info run.h5 | head -1`.
bool finish_results();

}  // namespace sherd
