// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Returns the approximate number of voxels that write_level_set() fills for the sheet. thickness: [T] m;
/// voxel: m, side of a voxel.
double expected_voxels(const TriangleSheet& sheet, std::span<const double> thickness, double voxel);

/// A body with a closed surface, whose normals point outward.
struct LevelSetBody {
    std::string name;  ///< name of its grid
    TriangleSheet surface;
    double voxel = 0;  ///< m, side of a voxel of its grid
};

/// Writes an OpenVDB file. Its grid `surface` is a level set of the sheet with its thickness (the sheet
/// itself has no inside): the distance from the sheet less half the thickness, m, everywhere inside and up to
/// three voxels outside. voxel: m, side of a voxel. thickness: [T] m, each at least twice `voxel`, or there
/// would be holes. Thicknesses that differ by less than a hundredth of a voxel may count as equal. Each of
/// `bodies` gets a level set of its own, whose distances reach three voxels inward and outward from its
/// surface. The same meshes give the same bytes. Throws Error (Fault::run) if the file cannot be written.
void write_level_set(const TriangleSheet& sheet, std::span<const double> thickness, double voxel,
                     std::span<const LevelSetBody> bodies, const std::filesystem::path& file);

}  // namespace sherd
