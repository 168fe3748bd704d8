// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sherd {

/// The values of a grid at some points.
struct GridSamples {
    std::vector<double> values;  ///< [N] value at each point
    double background = 0;       ///< value of the grid outside its active voxels
    std::size_t outside = 0;     ///< number of points with that value, since no voxel around them is active
};

/// Returns the values of the float grid `name` of an OpenVDB file at `points` [N], in the world space of the
/// file, interpolated trilinearly between the centres of voxels. An empty `name` stands for the only float
/// grid. Throws Error naming the file if it is missing, damaged or no OpenVDB file, or has no such grid.
GridSamples sample_float_grid(const std::filesystem::path& file, const std::string& name,
                              std::span<const Eigen::Vector3d> points);

}  // namespace sherd
