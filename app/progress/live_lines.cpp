// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/live_lines.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "app/messages/print.h"

namespace sherd {
namespace {

// ANSI escape sequences, which all terminals but those with TERM=dumb obey.
constexpr const char* erase_rest_of_line = "\x1b[K";
constexpr const char* erase_rest_of_screen = "\x1b[J";

bool can_move_the_cursor() {
    const char* kind = std::getenv("TERM");
    return kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
}

winsize size_of_terminal() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0) return {};
    return size;
}

void put(const std::string& text) {
    print_message("{}", text);
}

}  // namespace

LiveLines::LiveLines() : terminal(isatty(STDERR_FILENO) && can_move_the_cursor()) {}

LiveLines::~LiveLines() {
    leave();
}

std::size_t LiveLines::columns() const {
    const winsize size = size_of_terminal();
    return size.ws_col == 0 ? 80 : size.ws_col;
}

std::size_t LiveLines::rows() const {
    const winsize size = size_of_terminal();
    return size.ws_row == 0 ? 24 : size.ws_row;
}

std::string LiveLines::to_first_line() const {
    return drawn > 1 ? fmt::format("\r\x1b[{}A", drawn - 1) : "\r";
}

void LiveLines::draw(std::vector<std::string> lines) {
    if (!terminal) return;
    // A further row would scroll the first line away, out of reach of the cursor.
    lines.resize(std::min(lines.size(), std::max<std::size_t>(rows(), 2) - 1));
    std::string text = to_first_line();
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += (i == 0 ? "" : "\n") + lines[i] + erase_rest_of_line;
    // Erases lines of an earlier, longer drawing, and lines that a narrowed terminal has moved down.
    text += erase_rest_of_screen;
    drawn = lines.size();
    put(text + "\r");
}

void LiveLines::clear() {
    // Erases line by line first: some terminals keep a copy of a screen that is erased as a whole.
    if (drawn > 0) draw(std::vector<std::string>(drawn));
    if (drawn > 0) put(to_first_line());
    drawn = 0;
}

void LiveLines::leave() {
    if (drawn > 0) put("\n");
    drawn = 0;
}

}  // namespace sherd
