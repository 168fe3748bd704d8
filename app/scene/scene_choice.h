// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Choice of a variant of a scene file, and of changes.
struct SceneChoice {
    std::vector<std::string> overrides;  ///< KEY=VALUE with dotted keys; they win over the variant
    std::string variant;                 ///< name; empty: the scene without its variants
};

/// Returns the text of a scene file as recordings keep it: with the choice in comments at its end.
std::string recorded_text(std::string text, const SceneChoice& choice);

/// Returns the choice in a text of recorded_text().
SceneChoice recorded_choice(const std::string& text);

}  // namespace sherd
