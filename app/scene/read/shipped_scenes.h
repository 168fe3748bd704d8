// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// A scene that comes with the program.
struct ShippedScene {
    std::string name;            ///< path below the folder of the scenes, without .toml:
                                 ///< "experiments/bent_plate"
    std::filesystem::path file;  ///< absolute path
    std::string description;     ///< the first sentence of the comment that the file begins with
};

/// Returns the folder of the scenes that come with the running program. It is found from the place of the
/// program's own file, so that an installation may be moved; for a program in a build tree it is the folder
/// in the source tree. Throws Error (run) when the folder does not exist.
std::filesystem::path shipped_scene_folder();

/// Returns the scenes in `folder` and its subfolders, but not the studies. They are ordered by name, with
/// those in subfolders last.
std::vector<ShippedScene> shipped_scenes(const std::filesystem::path& folder);

/// Returns the one of `scenes` with this name, which may end with .toml. Throws Error (input) with the most
/// similar name when there is none.
ShippedScene shipped_scene(const std::string& name, const std::vector<ShippedScene>& scenes);

/// Returns the scene file that a user has given: the file `given` if it exists, or else `given` with .toml
/// appended, or else the shipped scene of this name. Throws Error (input), with the most similar name of a
/// shipped scene, if none of these exists.
std::filesystem::path find_scene(const std::string& given);

/// Returns the study file that a user has given: the file `given` if it exists, or else `given` with .toml
/// appended, or else the shipped study of this name. Returns `given` if none of these exists.
std::filesystem::path find_study(const std::string& given);

/// Returns the existing files that are named by texts in a scene file, as paths relative to the scene's
/// folder.
std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& scene);

}  // namespace sherd
