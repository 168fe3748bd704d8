// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sherd {

/// Writes a text. A failure is not thrown, and sets the stream's error flag.
void put_text(std::FILE* stream, std::string_view text);

/// Writes to stdout. After a failure the program continues; main() turns it into exit code 1 at the end.
template <class... Arguments>
void print_result(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    put_text(stdout, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Writes to stderr, after flushing stdout. Failures are ignored: a closed terminal, or a log on a full disk,
/// ends no run.
template <class... Arguments>
void print_message(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::fflush(stdout);
    put_text(stderr, fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Prints a message for each warning.
void print_warnings(const std::vector<std::string>& warnings);

/// Ends the program silently by SIGPIPE, as is usual without a reader of stdout; returns if the signal is
/// blocked.
void end_without_reader();

/// Flushes stdout; returns whether everything printed has been written. Does not return if the reader has
/// gone, as that of `sherd info run.h5 | head -1`.
bool finish_results();

}  // namespace sherd
