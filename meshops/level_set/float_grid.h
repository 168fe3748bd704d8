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
    std::vector<double> values;  ///< [N]
    double background = 0;       ///< value outside the active region
    std::size_t outside = 0;     ///< number of the points there: no voxel around them is active
};

/// Values of the float grid `name` of an OpenVDB file at points [N], interpolated between the voxels' centres
/// (trilinear). An empty `name` stands for the only float grid. Throws Error naming the file if it is
/// missing, damaged or no OpenVDB file, or has no such grid.
GridSamples sample_float_grid(const std::filesystem::path& file, const std::string& name,
                              std::span<const Eigen::Vector3d> points);

}  // namespace sherd
