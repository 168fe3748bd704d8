// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Files that the build embeds in the program.
namespace sherd::view_assets {

extern const std::string_view page;      ///< view_page.html, with placeholders %NAME%
extern const std::string_view three;     ///< three.js, minified (MIT licence)
extern const std::string_view controls;  ///< three.js' OrbitControls
extern const std::string_view playback;  ///< view_playback.js
extern const std::string_view paint;     ///< view_paint.js

}  // namespace sherd::view_assets
