// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// The closed surface of the solid that a grid describes.
struct GridSurface {
    std::vector<Eigen::Vector3d> points;                 ///< m
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< oriented outward
};

/// A solid as signed distances at the centres of cubic voxels (an OpenVDB grid), which fill the solid and a
/// layer around it. Between the centres distances are a quadratic spline, whose gradient is continuous. The
/// spline rounds edges by about a tenth of a voxel and makes a surface of radius R thinner by voxel^2 / (4
/// R).
class SignedDistanceGrid {
  public:
    struct Sample {
        double distance;  ///< m, negative inside; infinite beyond the layer
        Eigen::Vector3d gradient;
        Eigen::Matrix3d hessian;  ///< 1/m
    };

    /// Smallest size of a voxel, m: OpenVDB rejects transforms whose determinant is below 3e-15.
    static constexpr double finest = 2e-5;

    /// Samples the solid in a mesh. voxel, reach: m, size of the voxels and minimum height of the layer.
    /// Throws Error if voxels are too fine, or would be too many, or if the mesh encloses nothing: a hole
    /// wider than a voxel or two lets the outside in.
    static SignedDistanceGrid of_mesh(const Mesh& mesh, double voxel, double reach);
    /// Reads the level set `name` of an OpenVDB file (empty: the only one), in its own world space times
    /// `scale`. Its voxels are used unchanged; beyond the layer that it has, distances from its surface are
    /// added, inward to the middle and outward up to `reach` (m). If the voxels are not cubic, only the
    /// surface is kept and the distances are computed again. Throws Error naming the file if it is missing,
    /// damaged or no OpenVDB file, if it has no such grid, if the grid is no level set, if its voxels are
    /// more than 20 times as long as wide, or if they are too fine or too many.
    static SignedDistanceGrid of_level_set(const std::filesystem::path& file, const std::string& name,
                                           double scale, double reach);

    Sample sample(const Eigen::Vector3d& point) const;
    Eigen::Vector3d lower() const;  ///< m, corner of a box that contains the solid
    Eigen::Vector3d upper() const;
    double voxel() const;  ///< m
    /// Volume of the voxels inside, m^3.
    double volume() const;
    const GridSurface& surface() const;

  private:
    struct State;
    explicit SignedDistanceGrid(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state;
};

}  // namespace sherd
