// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_obstacle.h"

#include "app/render/creased_surface.h"
#include "app/render/trace/render_light.h"

namespace sherd {

RenderMesh obstacle_solid(const GridSurface& surface, const Eigen::Isometry3d& pose,
                          const Eigen::Vector3d& origin) {
    const CreasedSurface shown = creased(surface);
    RenderMesh mesh;
    for (std::size_t i = 0; i < shown.points.size(); ++i) {
        RenderVertex vertex;
        vertex.position = (pose * shown.points[i] - origin).cast<float>();
        vertex.normal = Eigen::Vector3d(pose.linear() * shown.normals[i]).cast<float>();
        vertex.colour = linear_colour(obstacle_grey);
        vertex.material = shown.points[i].cast<float>();
        mesh.vertices.push_back(vertex);
    }
    for (const auto& [a, b, c] : shown.triangles)
        mesh.triangles.push_back(
            {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    return mesh;
}

RenderPlane plane_of(const GridSurface& surface, const Eigen::Isometry3d& pose,
                     const Eigen::Vector3d& origin) {
    const std::array<std::int32_t, 3>& face = surface.triangles.front();
    const Eigen::Vector3d normal = pose.linear() * face_normal(surface, face).stableNormalized();
    return {(pose * surface.points[face[0]] - origin).cast<float>(), normal.cast<float>()};
}

Eigen::AlignedBox3d box_of(const GridSurface& surface, const Eigen::Isometry3d& pose) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : surface.points) box.extend(pose * point);
    return box;
}

}  // namespace sherd
