// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/number.h"

#include <charconv>
#include <cmath>

namespace sherd {

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
    if (error != std::errc() || end != text.end() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace sherd
