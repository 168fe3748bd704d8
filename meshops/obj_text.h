// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "meshops/write_mesh.h"

namespace sherd {

/// The content of an OBJ file, for mesh_bytes(). file: its name; the file of materials is named after it.
std::string obj_text(const TriangleSheet& sheet, const std::filesystem::path& file);

}  // namespace sherd
