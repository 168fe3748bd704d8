// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/wrapped.h"

#include <sys/ioctl.h>
#include <unistd.h>

namespace sherd {

std::string wrapped(std::string text, std::size_t width, std::size_t indent) {
    for (std::size_t begin = 0; text.size() - begin > width;) {
        const std::size_t space = text.rfind(' ', begin + width);
        if (space == std::string::npos || space <= begin) return text;
        text.replace(space, 1, "\n" + std::string(indent, ' '));
        begin = space + 1 + indent;
    }
    return text;
}

std::size_t terminal_columns() {
    winsize size{};
    return isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace sherd
