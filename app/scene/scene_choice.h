// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Variant of a scene file, and changes of its keys, that a user has chosen.
struct SceneChoice {
    std::vector<std::string> overrides;  ///< KEY=VALUE with dotted keys; they override the keys of the
                                         ///< variant, too
    std::string variant;                 ///< name of the variant; empty: the scene without a variant
};

/// Returns the text of a scene file as recordings keep it: with the choice in comments at its end.
std::string recorded_text(std::string text, const SceneChoice& choice);

/// Returns the choice that recorded_text() has appended to a scene's text.
SceneChoice recorded_choice(const std::string& text);

}  // namespace sherd
