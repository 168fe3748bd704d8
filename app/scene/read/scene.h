// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/keys/key_info.h"
#include "app/scene/scene.h"

namespace sherd {

/// Returns the names of the variants in a scene's text, in its order; empty if it has none. Throws Error like
/// read_scene() if a name is missing or invalid.
std::vector<std::string> variant_names(const std::string& text, const std::filesystem::path& file);

/// Returns the text of a scene. Throws Error if it cannot be read.
std::string read_scene_text(const std::filesystem::path& file);

/// Reads and checks a scene: the keys of the file, then those of the variant, then the overrides. Throws
/// Error with file:line, the key and what to do, on a missing file, a TOML syntax error (with line and
/// column), an unknown variant, an unknown key (with the nearest known one), a missing key, and a wrong type,
/// sign or range. The message has a line for each mistake. Mesh files are opened by make_mesh only.
Scene read_scene(const std::filesystem::path& file, const SceneChoice& choice = {});

/// Reads and checks the text of a scene, like read_scene(). file: its origin, for errors and for the names of
/// files in it; meshes: meshes that its sheets may name as given.
Scene parse_scene(std::string text, const std::filesystem::path& file, const SceneChoice& choice = {},
                  GivenMeshes meshes = {});

/// Documentation of the keys of scenes, from the root on.
SectionText scene_reference();

}  // namespace sherd
