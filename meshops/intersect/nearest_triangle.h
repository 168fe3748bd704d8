// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace sherd {

/// Finds the triangle of a surface that is nearest to a point.
class NearestTriangle {
  public:
    /// points: [3, P] m; triangles: numbers of their corners, as columns of `points`. Triangles without area
    /// are never the nearest. Throws Error (input) if no triangle has an area.
    NearestTriangle(const Eigen::Matrix3Xd& points, std::span<const std::array<std::int32_t, 3>> triangles);
    ~NearestTriangle();
    NearestTriangle(const NearestTriangle&) = delete;
    NearestTriangle& operator=(const NearestTriangle&) = delete;

    struct Found {
        std::size_t triangle = 0;
        double distance = 0;  ///< m
    };
    Found operator()(const Eigen::Vector3d& point) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree;
};

}  // namespace sherd
