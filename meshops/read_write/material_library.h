// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "meshops/surface_material.h"

namespace sherd {

/// Reads the materials of an .mtl file: SurfaceMaterial::definition of each, by name. Throws Error naming the
/// file, and the line, if it cannot be read or a `newmtl` has no name.
std::map<std::string, std::string> read_material_library(const std::filesystem::path& file);

/// Returns a definition with renamed(name) for the names of pictures in its `map_...`, `bump`, `disp`,
/// `decal`, `norm` and `refl` lines. Options of pictures stay.
std::string with_pictures(const std::string& definition,
                          const std::function<std::string(const std::string&)>& renamed);

/// The values of the first line of a definition that starts with the keyword: "0.8 0.2 0.2" for `Kd`; for a
/// picture its name. Empty if there is none.
std::string statement(const SurfaceMaterial& material, const std::string& keyword);

/// The .mtl file that an .obj file names.
std::filesystem::path material_file(const std::filesystem::path& obj);
/// The name of a face's material in an .obj file: `none` where it has none.
std::string material_name(const FaceMaterial& material);
/// The content of the file of materials of an .obj file: each material once, in order, with paths of pictures
/// relative to it.
std::string material_text(const std::vector<FaceMaterial>& materials, const std::filesystem::path& obj);

}  // namespace sherd
