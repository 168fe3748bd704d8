// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/scene/scene.h"

namespace sherd {

/// Throws Error unless `file` is a name for write_fault_picture(), and free or to be replaced.
void require_fault_file(const Scene& scene, const std::filesystem::path& file, bool force);

/// Writes a binary PLY file of all sheets, where the scene places them, with the faces that keep it from
/// starting in colours by their kind (of faces and of points, each face with points of its own), and prints
/// how many there are of which. Sheets whose mesh file cannot be read are left out. Without such a face it
/// writes nothing and says so. Throws Error when the file exists and not `force`, or cannot be written.
void write_fault_picture(const Scene& scene, const std::filesystem::path& file, bool force);

}  // namespace sherd
