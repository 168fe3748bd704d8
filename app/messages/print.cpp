// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/print.h"

#include <poll.h>
#include <unistd.h>

#include <csignal>

namespace sherd {
namespace {

/// Whether stdout is a pipe without a reader.
bool has_lost_reader() {
    pollfd stream{STDOUT_FILENO, POLLOUT, 0};
    return poll(&stream, 1, 0) == 1 && (stream.revents & POLLERR) != 0;
}

}  // namespace

void put_text(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);
}

void print_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) print_message("sherd: warning: {}\n", warning);
}

void end_without_reader() {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
}

bool finish_results() {
    const bool is_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (!is_written && has_lost_reader()) end_without_reader();
    return is_written;
}

}  // namespace sherd
