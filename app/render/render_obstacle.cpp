// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_obstacle.h"

#include "app/render/render_light.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t obstacle_grey = 0x8c8f93;
constexpr double smooth_cosine = 0.87;  // of a face with the mean of its neighbours: 30 degrees

/// As long as twice the area.
Vector3d face_normal(const GridSurface& surface, const std::array<std::int32_t, 3>& face) {
    const Vector3d& a = surface.points[face[0]];
    return (surface.points[face[1]] - a).cross(surface.points[face[2]] - a);
}

}  // namespace

RenderMesh obstacle_solid(const GridSurface& surface, const Eigen::Isometry3d& pose, const Vector3d& origin) {
    std::vector<Vector3d> mean(surface.points.size(), Vector3d::Zero());
    for (const auto& face : surface.triangles)
        for (const std::int32_t corner : face) mean[corner] += face_normal(surface, face);
    RenderMesh mesh;
    for (const auto& face : surface.triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vector3d flat = face_normal(surface, face).stableNormalized();
        for (const std::int32_t corner : face) {
            const Vector3d around = mean[corner].stableNormalized();
            const Vector3d normal = pose.linear() * (around.dot(flat) > smooth_cosine ? around : flat);
            RenderVertex vertex;
            vertex.position = (pose * surface.points[corner] - origin).cast<float>();
            vertex.normal = normal.cast<float>();
            vertex.colour = linear_colour(obstacle_grey);
            vertex.material = surface.points[corner].cast<float>();
            mesh.vertices.push_back(vertex);
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

Eigen::AlignedBox3d box_of(const GridSurface& surface, const Eigen::Isometry3d& pose) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& point : surface.points) box.extend(pose * point);
    return box;
}

}  // namespace sherd
