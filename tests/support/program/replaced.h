// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace sherd::test {

/// Returns the text with `to` in place of the first `from`. Throws std::runtime_error if there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the text has no " + from);
    return text.replace(at, from.size(), to);
}

}  // namespace sherd::test
