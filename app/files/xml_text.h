// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns `text` escaped for XML; control characters that XML excludes become `_`.
std::string xml_escaped(const std::string& text);

}  // namespace sherd
