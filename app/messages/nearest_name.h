// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sherd {

/// Returns the element of `names` that is fewest edits away from `name`; empty if none is similar. If one of
/// two names begins with the other one, this counts as one edit.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

}  // namespace sherd
