// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/keys/key_info.h"
#include "app/scene/scene.h"

namespace sherd {

/// Key of the variants of a scene.
inline constexpr const char* variant_key = "variant";

/// Returns the names of the variants in a scene's text, in the order of the text; empty if it has none. file:
/// for errors. Throws Error like read_scene() if a name is missing or invalid.
std::vector<std::string> variant_names(const std::string& text, const std::filesystem::path& file);

/// Returns the text of a scene file. Throws Error if it cannot be read.
std::string read_scene_text(const std::filesystem::path& file);

/// Reads and checks a scene. Keys of the variant replace keys of the file, and overrides replace both. Throws
/// Error with file:line, the key and what to do, on a missing file, a TOML syntax error (with line and
/// column), an unknown variant, an unknown key (with the nearest known one), a missing key, and a wrong type,
/// sign or range. The message has a line for each mistake. Mistakes in mesh files are found by make_mesh()
/// only.
Scene read_scene(const std::filesystem::path& file, const SceneChoice& choice = {});

/// Reads and checks the text of a scene, like read_scene(). file: file that the text comes from, for errors
/// and as the base of relative file names; meshes: meshes that sheets may name by `given`.
Scene parse_scene(std::string text, const std::filesystem::path& file, const SceneChoice& choice = {},
                  GivenMeshes meshes = {});

/// Reads and checks the text of a scene, like parse_scene(), with each of its variants in turn. Returns a
/// single scene if the scene has no variants or `choice` names one. Throws Error with the mistakes of all
/// variants, even if one of them has no valid name.
std::vector<Scene> parse_scenes(const std::string& text, const std::filesystem::path& file,
                                const SceneChoice& choice);

/// Returns the documentation of all keys of scenes, as a tree that begins at the root table.
SectionText scene_reference();

}  // namespace sherd
