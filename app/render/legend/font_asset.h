// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sherd {

/// Bytes of DejaVu Sans, a TrueType font, which the build embeds in the program.
extern const std::string_view font_asset;

}  // namespace sherd
