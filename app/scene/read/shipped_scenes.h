// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// A scene that comes with the program.
struct ShippedScene {
    std::string name;            ///< path below the folder of the scenes, without .toml
    std::filesystem::path file;  ///< absolute
    std::string description;     ///< the first sentence of the comment that the file begins with
};

/// Returns the folder of the scenes that come with the running program. It is found from the program's own
/// file, so that an installation may be moved; in a build tree it is the source's. Throws Error (run) when it
/// is not there.
std::filesystem::path shipped_scene_folder();

/// Returns the scenes in `folder`, but not the studies, those below subfolders last, in the order of their
/// names.
std::vector<ShippedScene> shipped_scenes(const std::filesystem::path& folder);

/// Returns the scene of this name, with or without .toml. Throws Error (input) with the nearest name when
/// there is none.
ShippedScene shipped_scene(const std::string& name, const std::vector<ShippedScene>& scenes);

/// Returns the file that `given` names: the file of this name, or else with .toml appended, or else the
/// shipped scene. Throws Error (input) with the nearest shipped scene if there is none.
std::filesystem::path find_scene(const std::string& given);

/// Returns the file that `given` names: the file of this name, or else with .toml appended, or else the
/// shipped study. Returns `given` if there is none.
std::filesystem::path find_study(const std::string& given);

/// Returns the files that a scene names and that are there, relative to the scene's folder.
std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& scene);

}  // namespace sherd
