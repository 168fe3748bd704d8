// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/unfold.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The halfedge out of a vertex from which all faces at it follow counterclockwise.
Halfedge first_outward(const Mesh& mesh, Vertex vertex) {
    for (const Halfedge in : mesh.halfedges_around_target(mesh.halfedge(vertex)))
        if (mesh.is_border(in)) return mesh.opposite(in);
    return mesh.opposite(mesh.halfedge(vertex));
}

}  // namespace

UnfoldedFan unfold_fan(const Mesh& mesh, Vertex vertex) {
    const Vector3d centre = position(mesh, vertex);
    UnfoldedFan fan;
    std::vector<double> angles{0}, lengths;
    const Halfedge first = first_outward(mesh, vertex);
    Halfedge out = first;
    for (;;) {
        fan.ring.push_back(mesh.target(out));
        const Vector3d side = position(mesh, mesh.target(out)) - centre;
        lengths.push_back(side.norm());
        if (mesh.is_border(out)) break;
        fan.faces.push_back(mesh.face(out));
        const Vector3d next = position(mesh, mesh.target(mesh.next(out))) - centre;
        angles.push_back(angles.back() + std::atan2(side.cross(next).norm(), side.dot(next)));
        out = mesh.opposite(mesh.prev(out));
        if (out != first) continue;
        fan.ring.push_back(mesh.target(first));
        lengths.push_back(lengths.front());
        break;
    }
    const double whole = mesh.is_border(out) ? std::numbers::pi : 2 * std::numbers::pi;
    const double scale = whole / angles.back();
    for (std::size_t i = 0; i < fan.ring.size(); ++i)
        fan.places.emplace_back(lengths[i] * std::cos(scale * angles[i]),
                                lengths[i] * std::sin(scale * angles[i]));
    return fan;
}

std::array<Vector2d, 4> unfold_pair(const Mesh& mesh, Halfedge h) {
    const Vector3d source = position(mesh, mesh.source(h));
    const Vector3d side = position(mesh, mesh.target(h)) - source;
    const double length = side.norm();
    const auto apex = [&](Halfedge at) {
        const Vector3d way = position(mesh, mesh.target(mesh.next(at))) - source;
        return Vector2d(way.dot(side) / length, way.cross(side).norm() / length);
    };
    const Vector2d above = apex(h), below = apex(mesh.opposite(h));
    return {Vector2d::Zero(), Vector2d(length, 0), above, Vector2d(below.x(), -below.y())};
}

}  // namespace sherd
