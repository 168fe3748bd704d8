// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace sherd {

/// The bytes of DejaVu Sans, a TrueType font, which the build puts into the program.
extern const std::string_view font_asset;

}  // namespace sherd
