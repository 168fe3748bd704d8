// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sherd {

/// Returns a number with its noun: "1 fragment", "2 fragments". plural: plural of the noun; needed if it is
/// not the noun with an appended s.
template <class Count>
std::string counted(Count count, std::string_view noun, std::string_view plural = {}) {
    std::string text =
        std::to_string(count) + " " + std::string(count == 1 || plural.empty() ? noun : plural);
    return count == 1 || !plural.empty() ? text : text + "s";
}

}  // namespace sherd
