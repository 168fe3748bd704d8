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

/// A solid, given by signed distances from its surface at the centres of cubic voxels (an OpenVDB grid). The
/// voxels fill the solid and a layer around it. Between their centres, a quadratic spline with a continuous
/// gradient gives the distance. The spline rounds edges by about a tenth of a voxel, and moves the surface of
/// a ball of radius R inward by voxel^2 / (4 R).
class SignedDistanceGrid {
  public:
    struct Sample {
        double distance;  ///< m, negative inside; infinite beyond the layer
        Eigen::Vector3d gradient;
        Eigen::Matrix3d hessian;  ///< 1/m
    };

    /// Smallest side of a voxel, m: OpenVDB rejects transforms whose determinant is below 3e-15.
    static constexpr double finest = 2e-5;

    /// Makes the grid of the solid within `mesh`. voxel: m, side of the voxels. reach: m, smallest thickness
    /// of the layer around the solid. Throws Error if the voxels are too fine or would be too many, or if the
    /// mesh encloses no solid at this size of voxels: it is thinner than a voxel, or a hole wider than a
    /// voxel or two connects inside and outside.
    static SignedDistanceGrid of_mesh(const Mesh& mesh, double voxel, double reach);
    /// Makes the grid from the level set `name` of `file`, an OpenVDB file; an empty name stands for the only
    /// level set. Positions are those of the world space of the file times `scale`. The distances at the
    /// voxels of the file are used unchanged, but scaled. Since a level set has distances in a thin layer
    /// only, further distances from its surface are computed, inward to the middle of the solid and outward
    /// up to `reach` (m). If the voxels are not cubic, all distances are computed from the surface. Throws
    /// Error naming the file if it is missing, damaged or no OpenVDB file, if it has no such grid, if the
    /// grid is no level set, if its voxels are more than 20 times as long as wide, or if they are too fine or
    /// too many.
    static SignedDistanceGrid of_level_set(const std::filesystem::path& file, const std::string& name,
                                           double scale, double reach);

    Sample sample(const Eigen::Vector3d& point) const;
    Eigen::Vector3d lower() const;  ///< m, lowest corner of a box that contains the solid
    Eigen::Vector3d upper() const;
    double voxel() const;  ///< m, side of a voxel
    /// Total volume of the voxels whose centres are inside the solid, m^3.
    double volume() const;
    const GridSurface& surface() const;

  private:
    struct State;
    explicit SignedDistanceGrid(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state;
};

}  // namespace sherd
