// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace sherd {

/// Parses a text that is a finite number and nothing else; otherwise none.
std::optional<double> number_of(std::string_view text);

}  // namespace sherd
