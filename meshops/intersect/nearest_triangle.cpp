// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/nearest_triangle.h"

#include <vector>

#include "meshops/error.h"
#include "meshops/intersect/aabb_tree.h"

namespace sherd {

struct NearestTriangle::Tree {
    std::vector<Kernel::Triangle_3> triangles;
    std::vector<std::size_t> numbers;  ///< number of each triangle in the constructor's list
    AabbTree<TrianglePrimitive> boxes;
};

NearestTriangle::NearestTriangle(const Eigen::Matrix3Xd& points,
                                 std::span<const std::array<std::int32_t, 3>> triangles)
    : tree(std::make_unique<Tree>()) {
    const auto point = [&](std::int32_t i) { return Point(points(0, i), points(1, i), points(2, i)); };
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& [a, b, c] = triangles[t];
        const Kernel::Triangle_3 triangle(point(a), point(b), point(c));
        if (triangle.is_degenerate()) continue;
        tree->triangles.push_back(triangle);
        tree->numbers.push_back(t);
    }
    if (tree->triangles.empty()) throw Error("a surface without area has no nearest triangle");
    tree->boxes.insert(tree->triangles.cbegin(), tree->triangles.cend());
}

NearestTriangle::~NearestTriangle() = default;

NearestTriangle::Found NearestTriangle::operator()(const Eigen::Vector3d& point) const {
    const auto [at, primitive] = tree->boxes.closest_point_and_primitive({point.x(), point.y(), point.z()});
    return {tree->numbers[static_cast<std::size_t>(primitive - tree->triangles.cbegin())],
            (Eigen::Vector3d(at.x(), at.y(), at.z()) - point).norm()};
}

}  // namespace sherd
