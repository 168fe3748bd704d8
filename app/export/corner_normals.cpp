// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/corner_normals.h"

#include <Eigen/Geometry>
#include <cmath>

#include "app/render/creased_surface.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

constexpr double smooth_cosine = 0.87;  // 30 degrees between a normal of the rim and the mean at a point

Vector3d unit(const Vector3d& vector) {
    const double length = vector.norm();
    return length > 0 ? Vector3d(vector / length) : Vector3d::UnitZ();
}

class NormalsOfSheet {
  public:
    NormalsOfSheet(std::span<const Vector3d> points, const TriangleSheet& sheet)
        : points(points), sheet(sheet), side(points.size(), Vector3d::Zero()), rim(side) {
        for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
            flat.push_back(area_normal(t));
            if (shading(t) == Shading::broken) continue;
            std::vector<Vector3d>& mean = shading(t) == Shading::smooth ? side : rim;
            for (int k = 0; k < 3; ++k) mean[sheet.triangles[t][k]] += angle(t, k) * unit(flat[t]);
        }
    }

    Vector3d at(std::size_t t, int corner) const {
        const std::int32_t point = sheet.triangles[t][corner];
        if (shading(t) == Shading::smooth) return unit(side[point]);
        const Vector3d own = unit(flat[t] + flat[partner(t)]), round = unit(rim[point]);
        return shading(t) == Shading::rim && round.dot(own) > smooth_cosine ? round : own;
    }

  private:
    Shading shading(std::size_t t) const {
        return sheet.shading.empty() ? Shading::smooth : sheet.shading[t];
    }
    /// Returns the other triangle of a quadrilateral of the rim or of a crack face. Quadrilaterals are pairs
    /// of triangles that follow all other triangles.
    std::size_t partner(std::size_t t) const {
        const bool is_second = (sheet.triangles.size() - t) % 2 == 1;
        return is_second ? t - 1 : t + 1;
    }
    Vector3d area_normal(std::size_t t) const {
        const auto& [a, b, c] = sheet.triangles[t];
        return (points[b] - points[a]).cross(points[c] - points[a]);
    }
    double angle(std::size_t t, int corner) const {
        const auto& triangle = sheet.triangles[t];
        const Vector3d& at = points[triangle[corner]];
        const Vector3d a = points[triangle[(corner + 1) % 3]] - at,
                       b = points[triangle[(corner + 2) % 3]] - at;
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }

    std::span<const Vector3d> points;
    const TriangleSheet& sheet;
    std::vector<Vector3d> side, rim;  ///< [P] sums of the normals of the sides, and of the rim, at each point
    std::vector<Vector3d> flat;       ///< [T] normals of the triangles, as long as twice their area
};

}  // namespace

CornerNormals corner_normals(std::span<const Vector3d> points, const TriangleSheet& sheet) {
    const NormalsOfSheet normals(points, sheet);
    CornerNormals result;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        result.push_back({normals.at(t, 0), normals.at(t, 1), normals.at(t, 2)});
    return result;
}

CornerNormals creased_normals(const TriangleSheet& obstacle) {
    const CreasedSurface surface = creased({obstacle.points, obstacle.triangles});
    CornerNormals result;
    for (const auto& [a, b, c] : surface.triangles)
        result.push_back({surface.normals[a], surface.normals[b], surface.normals[c]});
    return result;
}

}  // namespace sherd
