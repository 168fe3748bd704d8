// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace sherd {

/// The finite number that a text is, all of it; none if it is anything else.
std::optional<double> number_of(std::string_view text);

}  // namespace sherd
