// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/range.h"

#include <fmt/format.h>

namespace sherd {

std::string Range::words() const {
    if (!has_least() && !has_most()) return "a finite number";
    if (!has_most() && least == 0) return with_least ? "a number of 0 or more" : "a positive number";
    if (!has_most())
        return with_least ? fmt::format("a number of {} or more", least)
                          : fmt::format("a number above {}", least);
    if (with_least && with_most) return fmt::format("a number from {} to {}", least, most);
    if (with_most) return fmt::format("a number above {}, and {} at most", least, most);
    return fmt::format("a number between {} and {}", least, most);
}

}  // namespace sherd
