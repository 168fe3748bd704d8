// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sherd {

/// Writes a text to `stream`. On failure does not throw, but sets the stream's error flag.
void put_text(std::FILE* stream, std::string_view text);

/// Writes to stdout. After a failure the program continues; finish_results() detects the failure at the end.
template <class... Arguments>
void print_result(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    put_text(stdout, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Writes to stderr, after flushing stdout. Failures are ignored, so that a closed terminal, or a log on a
/// full disk, ends no run.
template <class... Arguments>
void print_message(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::fflush(stdout);
    put_text(stderr, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Prints a message for each warning.
void print_warnings(const std::vector<std::string>& warnings);

/// Ends the program silently by SIGPIPE, as programs usually end when stdout has no reader any more. Returns
/// if the signal is blocked.
void end_without_reader();

/// Flushes stdout; returns whether everything that was printed has been written. If the reader of stdout has
/// ended, for example in `sherd info run.h5 | head -1`, ends the program by end_without_reader().
bool finish_results();

}  // namespace sherd
