// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// The closed surface that a grid stands for.
struct GridSurface {
    std::vector<Eigen::Vector3d> points;                 ///< m
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< outward
};

/// A solid as signed distances at the centres of cubic voxels (an OpenVDB grid), which fill it and a layer
/// around it. Between them distances are a quadratic spline, so that its gradient is continuous; it rounds
/// edges by about a tenth of a voxel, and makes a surface of radius R thinner by voxel^2 / (4 R).
class SignedDistanceGrid {
  public:
    struct Sample {
        double distance;  ///< m, negative inside; infinite beyond the layer
        Eigen::Vector3d gradient;
        Eigen::Matrix3d hessian;  ///< 1/m
    };

    /// voxel, reach: m, size of the voxels and least height of the layer. Throws Error when there would be
    /// too many voxels, or when the mesh encloses nothing: a hole wider than a voxel or two lets the outside
    /// in.
    static SignedDistanceGrid of_mesh(const Mesh& mesh, double voxel, double reach);
    /// The level set `name` of an OpenVDB file (empty: the only one), in its own world space times `scale`.
    /// Its voxels are taken as they are; beyond the layer that it has, inward to the middle and outward as
    /// far as `reach`, distances from its surface are added. Of voxels that are not cubic only the surface is
    /// kept, with the distances made anew. Throws Error naming the file when it is missing, damaged or no
    /// OpenVDB file, has no such grid, or one that is no level set.
    static SignedDistanceGrid of_level_set(const std::filesystem::path& file, const std::string& name,
                                           double scale, double reach);

    Sample sample(const Eigen::Vector3d& point) const;
    Eigen::Vector3d lower() const;  ///< m, corner of a box that holds the solid
    Eigen::Vector3d upper() const;
    double voxel() const;  ///< m
    /// m^3, of the voxels inside.
    double volume() const;
    const GridSurface& surface() const;

  private:
    struct State;
    explicit SignedDistanceGrid(std::shared_ptr<const State> state);
    std::shared_ptr<const State> state;
};

}  // namespace sherd
