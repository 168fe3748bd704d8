// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/bent_start.h"

#include <fmt/format.h>

#include <cmath>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double flat = 1e-6;  // share of the mesh's diagonal: accuracy of single-precision files

Vector3d normal_of_flat(const Mesh& mesh, const BendSpec& bend) {
    const MeshMeasures extent = measure(mesh);
    Vector3d normal = triangle_normal(face_points(mesh, Face(0))).normalized();
    const Vector3d on = position(mesh, Vertex(0));
    for (const Vertex v : mesh.vertices())
        if (std::abs(normal.dot(position(mesh, v) - on)) > flat * (extent.upper - extent.lower).norm())
            throw Error(fmt::format("{}: needs a sheet that is flat at rest", bend.where));
    return normal;
}

}  // namespace

Positions bent_start(const BendSpec& bend, const Mesh& placed, const Eigen::Isometry3d& place) {
    const Vector3d normal = normal_of_flat(placed, bend), from = place * bend.from;
    Vector3d along = place.linear() * bend.along;
    along -= normal.dot(along) * normal;
    if (along.norm() < flat)
        throw Error(fmt::format("{}.along: must not be the sheet's normal: give a direction in its plane",
                                bend.where));
    along.normalize();
    Positions start(3, static_cast<Index>(placed.number_of_vertices()));
    for (const Vertex v : placed.vertices()) {
        const Vector3d p = position(placed, v);
        const double length = along.dot(p - from), half = 0.5 * bend.curvature * length;
        // Chord of the arc, at half the arc's angle to the tangent.
        const double chord = half == 0 ? length : length * std::sin(half) / half;
        start.col(static_cast<Index>(v)) =
            p + (chord * std::cos(half) - length) * along + chord * std::sin(half) * normal;
    }
    return start;
}

}  // namespace sherd
