// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// `text` as it is written between tags and quotes of XML; `_` for control characters that XML cannot have.
std::string xml_escaped(const std::string& text);

}  // namespace sherd
