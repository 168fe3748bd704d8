// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "meshops/write_mesh.h"

namespace sherd {

/// How many voxels level_set_of() would fill, roughly.
double expected_voxels(const TriangleSheet& sheet, std::span<const double> thickness, double voxel);

/// Writes an OpenVDB file with the level set `surface` of the sheet with its thickness: the distance from the
/// sheet less half the thickness, negative within, out to three voxels (a level set of the sheet itself would
/// have no inside). thickness: [T] m, each at least twice the edge length `voxel` (m), else there would be
/// holes. The same sheet gives the same bytes. Throws Error (Fault::run) when the file cannot be written.
void write_level_set(const TriangleSheet& sheet, std::span<const double> thickness, double voxel,
                     const std::filesystem::path& file);

}  // namespace sherd
