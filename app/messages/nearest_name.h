// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sherd {

/// The name of `names` with the fewest edits from `name`; empty when none is similar.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

}  // namespace sherd
