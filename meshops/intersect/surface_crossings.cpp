// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/surface_crossings.h"

#include "meshops/intersect/aabb_tree.h"

namespace sherd {
namespace {

using Triangle = Kernel::Triangle_3;

Point point(const Eigen::Vector3d& at) {
    return {at.x(), at.y(), at.z()};
}

}  // namespace

std::vector<Face> surface_crossings(const Mesh& mesh, std::span<const Eigen::Vector3d> points,
                                    std::span<const std::array<std::int32_t, 3>> triangles) {
    std::vector<Triangle> surface;
    for (const auto& [a, b, c] : triangles) {
        const Triangle triangle(point(points[a]), point(points[b]), point(points[c]));
        if (!triangle.is_degenerate()) surface.push_back(triangle);
    }
    const AabbTree<TrianglePrimitive> tree(surface.cbegin(), surface.cend());
    std::vector<Face> crossing;
    for (const Face face : mesh.faces()) {
        const Halfedge edge = mesh.halfedge(face);
        const Triangle triangle(mesh.point(mesh.source(edge)), mesh.point(mesh.target(edge)),
                                mesh.point(mesh.target(mesh.next(edge))));
        if (!triangle.is_degenerate() && tree.do_intersect(triangle)) crossing.push_back(face);
    }
    return crossing;
}

}  // namespace sherd
