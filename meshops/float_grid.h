// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace sherd {

/// What a grid holds at some points.
struct GridSamples {
    std::vector<double> values;  ///< [N]
    double background = 0;       ///< value outside the active region
    std::size_t outside = 0;     ///< how many of the points lie there: no voxel around them is active
};

/// Values of the float grid `name` of an OpenVDB file at points [N], interpolated between the centres of the
/// voxels (trilinear). An empty `name` stands for the only float grid. Throws Error naming the file when it
/// is missing, damaged or no OpenVDB file, or has no such grid.
GridSamples sample_float_grid(const std::filesystem::path& file, const std::string& name,
                              std::span<const Eigen::Vector3d> points);

}  // namespace sherd
