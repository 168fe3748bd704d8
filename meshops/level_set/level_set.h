// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Approximate number of voxels that write_level_set() fills.
double expected_voxels(const TriangleSheet& sheet, std::span<const double> thickness, double voxel);

/// A body with a closed surface, which faces outward.
struct LevelSetBody {
    std::string name;  ///< name of its grid
    TriangleSheet surface;
    double voxel = 0;  ///< m
};

/// Writes an OpenVDB file with the thickened sheet as a level set named `surface`: the distance from the
/// sheet less half the thickness, negative inside, out to three voxels (a level set of the sheet itself would
/// have no inside). thickness: [T] m, each at least twice the voxel's edge length `voxel` (m), or there would
/// be holes. Thicknesses that differ by less than a hundredth of a voxel may count as one. Each body gets a
/// grid of its own, whose distances reach three voxels inside, too. The same meshes give the same bytes.
/// Throws Error (Fault::run) when the file cannot be written.
void write_level_set(const TriangleSheet& sheet, std::span<const double> thickness, double voxel,
                     std::span<const LevelSetBody> bodies, const std::filesystem::path& file);

}  // namespace sherd
