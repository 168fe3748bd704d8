// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "meshops/surface_material.h"

namespace sherd {

/// Reads an .mtl file. Returns the SurfaceMaterial::definition of each material, by the name of the material.
/// Throws Error naming the file, and the line, if the file cannot be read or a `newmtl` has no name.
std::map<std::string, std::string> read_material_library(const std::filesystem::path& file);

/// Returns `definition` with renamed(name) in place of the name of each picture in its `map_...`, `bump`,
/// `disp`, `decal`, `norm` and `refl` lines. The options in front of a name are kept.
std::string with_pictures(const std::string& definition,
                          const std::function<std::string(const std::string&)>& renamed);

/// Returns the text behind `keyword` in the first line of the definition that starts with it, such as "0.8
/// 0.2 0.2" for `Kd`; if it is a keyword of pictures, the name of the picture. Empty if there is no such
/// line.
std::string statement(const SurfaceMaterial& material, const std::string& keyword);

/// Returns the name of the .mtl file to which an .obj file written as `obj` refers.
std::filesystem::path material_file(const std::filesystem::path& obj);
/// Returns the name of a face's material in an .obj file: "none" if the face has no material.
std::string material_name(const FaceMaterial& material);
/// Returns the content of the .mtl file for the .obj file `obj`: each of `materials` once, in their order,
/// with paths of pictures relative to the folder of `obj`.
std::string material_text(const std::vector<FaceMaterial>& materials, const std::filesystem::path& obj);

}  // namespace sherd
