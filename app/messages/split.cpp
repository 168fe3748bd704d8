// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/split.h"

namespace sherd {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == separator)
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

}  // namespace sherd
