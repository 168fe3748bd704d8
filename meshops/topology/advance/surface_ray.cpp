// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/surface_ray.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int most_faces = 200;  // most faces of a ray; beyond, round-off makes it circle around a vertex

struct RayStart {
    Halfedge opposite;  ///< side of the first face opposite to the tip
    Vector3d direction;
};

/// Finds the face at the vertex `tip` in which a ray in the direction `wanted` begins, as seen along the
/// normal of the vertex. Returns nullopt if the ray points off the sheet.
std::optional<RayStart> ray_start(const Mesh& mesh, Vertex tip, const Vector3d& wanted) {
    constexpr double round_off = 1e-9;
    const Vector3d normal = vertex_normal(mesh, tip).normalized(), centre = position(mesh, tip);
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    const auto seen = [&](const Vector3d& way) { return Vector2d(way.dot(u), way.dot(v)); };
    const Vector2d d = seen(wanted);
    if (!(d.norm() > round_off * wanted.norm())) return std::nullopt;
    std::optional<RayStart> start;
    double most = -round_off;
    for (const Halfedge in : mesh.halfedges_around_target(mesh.halfedge(tip))) {
        if (mesh.is_border(in)) continue;
        const Halfedge opposite = mesh.prev(in);
        const Vector3d a = position(mesh, mesh.source(opposite)) - centre;
        const Vector3d b = position(mesh, mesh.target(opposite)) - centre;
        Eigen::Matrix2d sides;
        sides << seen(a), seen(b);
        if (sides.determinant() <= 0) continue;
        const Vector2d parts = sides.inverse() * d / d.norm();
        const double inside = std::min(parts[0] * a.norm(), parts[1] * b.norm());
        if (inside <= most) continue;
        most = inside;
        start = {opposite, (std::max(parts[0], 0.0) * a + std::max(parts[1], 0.0) * b).normalized()};
    }
    return start;
}

/// Exit of a line from a face: the side of the face, and the distance (m) along the line.
struct Exit {
    Halfedge side;
    double distance;
};

/// Finds where the line from `from` in the direction `along`, in the plane of a face, leaves the face. sides:
/// the sides of the face through which the line may leave.
Exit exit_through(const Mesh& mesh, std::span<const Halfedge> sides, const Vector3d& from,
                  const Vector3d& along) {
    const Vector3d normal = triangle_normal(face_points(mesh, mesh.face(sides.front())));
    Exit exit{sides.front(), std::numeric_limits<double>::infinity()};
    for (const Halfedge side : sides) {
        const Vector3d start = position(mesh, mesh.source(side));
        const Vector3d outward = (position(mesh, mesh.target(side)) - start).cross(normal);
        const double rate = along.dot(outward);
        const double distance = std::max((start - from).dot(outward) / rate, 0.0);
        if (rate > 0 && distance < exit.distance) exit = {side, distance};
    }
    return exit;
}

/// Turns `along`, a direction in the plane of the face of h, about h into the plane of the opposite face.
Vector3d turned_over(const Mesh& mesh, Halfedge h, const Vector3d& along) {
    const Vector3d edge = (position(mesh, mesh.target(h)) - position(mesh, mesh.source(h))).normalized();
    const Vector3d normal = triangle_normal(face_points(mesh, mesh.face(mesh.opposite(h)))).normalized();
    const double ahead = along.dot(edge), across = std::sqrt(std::max(1 - ahead * ahead, 0.0));
    return (ahead * edge + across * edge.cross(normal)).normalized();
}

}  // namespace

Vector3d vertex_normal(const Mesh& mesh, Vertex vertex) {
    const Vector3d centre = position(mesh, vertex);
    Vector3d sum = Vector3d::Zero();
    for (const Halfedge in : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
        if (mesh.is_border(in)) continue;
        const Vector3d a = position(mesh, mesh.target(mesh.next(in))) - centre;
        const Vector3d b = position(mesh, mesh.source(in)) - centre;
        const Vector3d normal = a.cross(b);
        sum += std::atan2(normal.norm(), a.dot(b)) * normal.normalized();
    }
    return sum;
}

std::optional<SurfaceRay> SurfaceRay::from(const Mesh& mesh, Vertex tip, const Vector3d& direction,
                                           double length, const std::function<bool(Edge)>& stops) {
    const auto start = ray_start(mesh, tip, direction);
    if (!start) return std::nullopt;
    SurfaceRay ray;
    std::vector<Halfedge> sides{start->opposite};
    Segment segment{mesh.face(start->opposite), position(mesh, tip), start->direction, 0};
    for (int i = 0; i < most_faces; ++i) {
        ray.segments.push_back(segment);
        const auto [side, distance] = exit_through(mesh, sides, segment.start, segment.direction);
        ray.whole = std::min(segment.begin + distance, length);
        if (segment.begin + distance >= length) break;
        const Vector3d from = position(mesh, mesh.source(side)), to = position(mesh, mesh.target(side));
        const Vector3d crossing = segment.start + distance * segment.direction;
        const Halfedge over = mesh.opposite(side);
        if (mesh.is_border(over) || stops(mesh.edge(side))) {
            ray.stop = side;
            ray.stop_fraction =
                std::clamp((crossing - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
            break;
        }
        segment = {mesh.face(over), crossing, turned_over(mesh, side, segment.direction),
                   segment.begin + distance};
        sides = {mesh.next(over), mesh.prev(over)};
    }
    return ray;
}

const SurfaceRay::Segment& SurfaceRay::segment_at(double distance) const {
    std::size_t i = segments.size() - 1;
    while (i > 0 && segments[i].begin > distance) --i;
    return segments[i];
}

SurfacePoint SurfaceRay::at(const Mesh& mesh, double distance) const {
    const Segment& segment = segment_at(distance);
    return nearest_point(mesh, segment.face, segment.start + (distance - segment.begin) * segment.direction);
}

}  // namespace sherd
