// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_tip.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int meridians = 24, parallels = 12;
constexpr double cone_width = 0.75;  // radius of the cone's base over the radius of the ball

/// Point and normal of the profile of a body of revolution. Components: along the axis of the body, away from
/// the axis.
struct ProfilePoint {
    Vector2d place, normal;
};

/// Adds the surface of revolution of a profile about the mark's axis.
void revolve(const std::vector<ProfilePoint>& profile, const TipMark& mark, const Vector3d& origin,
             RenderMesh& mesh) {
    const Vector3d side = mark.direction.unitOrthogonal(), other = mark.direction.cross(side);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const ProfilePoint& point : profile)
        for (int i = 0; i < meridians; ++i) {
            const double angle = 2 * std::numbers::pi * i / meridians;
            const Vector3d away = std::cos(angle) * side + std::sin(angle) * other;
            const auto in_space = [&](const Vector2d& flat) -> Vector3d {
                return flat.x() * mark.direction + flat.y() * away;
            };
            RenderVertex vertex;
            vertex.position = (mark.place - origin + in_space(point.place)).cast<float>();
            vertex.normal = in_space(point.normal).cast<float>();
            vertex.colour = mark.colour;
            vertex.material = vertex.position;
            mesh.vertices.push_back(vertex);
        }
    for (std::uint32_t ring = 0; ring + 1 < profile.size(); ++ring)
        for (std::uint32_t i = 0; i < meridians; ++i) {
            const std::uint32_t a = first + ring * meridians + i,
                                b = first + ring * meridians + (i + 1) % meridians;
            mesh.triangles.push_back({a, b, b + meridians});
            mesh.triangles.push_back({a, b + meridians, a + meridians});
        }
}

std::vector<ProfilePoint> ball(double radius) {
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= parallels; ++i) {
        const double angle = std::numbers::pi * i / parallels;
        const Vector2d normal(-std::cos(angle), std::sin(angle));
        profile.push_back({radius * normal, normal});
    }
    return profile;
}

std::vector<ProfilePoint> cone(double width, double reach) {
    const Vector2d normal = Vector2d(width, reach).normalized();
    return {{{0, width}, normal}, {{reach, 0}, normal}};
}

}  // namespace

RenderMesh tip_marks(const std::vector<TipMark>& marks, const Vector3d& origin) {
    RenderMesh mesh;
    for (const TipMark& mark : marks) {
        revolve(ball(mark.radius), mark, origin, mesh);
        revolve(cone(cone_width * mark.radius, mark.reach), mark, origin, mesh);
    }
    return mesh;
}

}  // namespace sherd
