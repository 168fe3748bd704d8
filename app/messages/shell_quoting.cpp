// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/shell_quoting.h"

#include <string_view>

namespace sherd {

std::string shell_quoted(const std::string& word) {
    constexpr std::string_view plain =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string path_argument(const std::filesystem::path& path) {
    return path.string().starts_with('-') ? "./" + path.string() : path.string();
}

}  // namespace sherd
