// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/creased_surface.h"

namespace sherd {
namespace {

constexpr double smooth_cosine = 0.87;  // cosine of 30 degrees

}  // namespace

Eigen::Vector3d face_normal(const GridSurface& surface, const std::array<std::int32_t, 3>& face) {
    const Eigen::Vector3d& a = surface.points[face[0]];
    return (surface.points[face[1]] - a).cross(surface.points[face[2]] - a);
}

CreasedSurface creased(const GridSurface& surface) {
    CreasedSurface result;
    std::vector<Eigen::Vector3d> mean(surface.points.size(), Eigen::Vector3d::Zero());
    for (const auto& face : surface.triangles)
        for (const std::int32_t corner : face) mean[corner] += face_normal(surface, face);
    const auto add = [&](std::int32_t point, const Eigen::Vector3d& normal) {
        result.points.push_back(surface.points[point]);
        result.point_of.push_back(point);
        result.normals.push_back(normal.isZero(0) ? Eigen::Vector3d::UnitZ() : normal);
        return static_cast<std::int32_t>(result.points.size()) - 1;
    };
    std::vector<std::int32_t> smooth(surface.points.size(), -1);  // smooth corner of each point
    for (const auto& face : surface.triangles) {
        const Eigen::Vector3d flat = face_normal(surface, face).stableNormalized();
        auto& corners = result.triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d around = mean[face[k]].stableNormalized();
            const bool is_smooth = around.dot(flat) > smooth_cosine;
            if (is_smooth && smooth[face[k]] < 0) smooth[face[k]] = add(face[k], around);
            corners[k] = is_smooth ? smooth[face[k]] : add(face[k], flat);
        }
    }
    return result;
}

CreasedSurface reshaped(CreasedSurface creased, const std::vector<Eigen::Vector3d>& points) {
    for (std::size_t i = 0; i < creased.points.size(); ++i) creased.points[i] = points[creased.point_of[i]];
    std::vector<Eigen::Vector3d> sums(creased.points.size(), Eigen::Vector3d::Zero());
    const GridSurface surface{creased.points, creased.triangles};
    for (const auto& face : creased.triangles)
        for (const std::int32_t corner : face) sums[corner] += face_normal(surface, face);
    for (std::size_t i = 0; i < sums.size(); ++i)
        creased.normals[i] = sums[i].isZero(0) ? Eigen::Vector3d::UnitZ() : sums[i].stableNormalized();
    return creased;
}

}  // namespace sherd
