// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/scene/scene.h"

namespace sherd {

/// Throws Error unless `file` ends in .ply, is no input of the scene, and does not exist or may be replaced
/// (`force`).
void require_fault_file(const Scene& scene, const std::filesystem::path& file, bool force);

/// Writes a binary PLY file of all sheets, where the scene places them, and prints a legend. Faces with a
/// fault that keeps the scene from starting are coloured by the kind of fault; each face has points of its
/// own, in the same colour. Sheets whose mesh file cannot be read are left out. If no face has a fault,
/// writes no file, and prints this. Throws Error if the file exists and not `force`, or cannot be written.
void write_fault_picture(const Scene& scene, const std::filesystem::path& file, bool force);

}  // namespace sherd
