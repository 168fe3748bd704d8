// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/solid/thicken.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace sherd {
namespace {

using Eigen::Vector3d;

/// Upper bound of the offset of a point, in half thicknesses: at a fold by more than 120 degrees the body
/// gets thinner; without the bound it would get a spike there.
constexpr double largest_stretch = 2;
constexpr double largest_turn = std::numbers::pi / 9, largest_turn_touching = std::numbers::pi / 2;
/// Fractions of the thickness: the distance up to which points on the two sides of a crack are offset in the
/// same direction, and the width of the gap left between the sides of a closed crack.
constexpr double together_distance = 0.5, crack_width = 0.01;

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns the value of a triangle of the body, given the value of its source triangle and the numbers of its
/// corners in the source triangle. Only texture coordinates depend on the corners.
template <class Value>
Value with_corners(const Value& value, const std::array<int, 3>& corners) {
    if constexpr (std::same_as<Value, FaceTexture>)
        return {value[corners[0]], value[corners[1]], value[corners[2]]};
    else
        return value;
}

/// A side of a triangle that no other triangle shares.
struct BoundaryEdge {
    std::int32_t from, to;
    std::size_t triangle;
    int side;  ///< number of the corner `from` in the triangle
};

/// The boundary edges, in the order of their triangles.
std::vector<BoundaryEdge> boundary_edges(const TriangleSheet& sheet) {
    std::vector<std::array<std::int32_t, 2>> sides;
    for (const auto& [a, b, c] : sheet.triangles) {
        sides.push_back({a, b});
        sides.push_back({b, c});
        sides.push_back({c, a});
    }
    auto sorted = sides;
    std::ranges::sort(sorted);
    std::vector<BoundaryEdge> boundary;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const auto& [from, to] = sides[i];
        if (!std::ranges::binary_search(sorted, std::array{to, from}))
            boundary.push_back({from, to, i / 3, static_cast<int>(i % 3)});
    }
    return boundary;
}

/// Sums over the triangles around a point.
struct Surroundings {
    Vector3d direction = Vector3d::Zero();    ///< sum of unit normals weighted by the angle at the point
    Vector3d area_normal = Vector3d::Zero();  ///< m^2, sum of unit normals weighted by twice the area
    double area = 0, volume = 0;         ///< twice the area (m^2); twice the area times the thickness (m^3)
    Vector3d inward = Vector3d::Zero();  ///< for boundary edges at the point, sum of unit vectors across the
                                         ///< edge into its triangle

    double thickness() const { return area > 0 ? volume / area : 0; }
    Vector3d offset() const {
        const Vector3d normal = direction.normalized();
        const double height = std::max(area_normal.dot(normal), area / largest_stretch);
        return area > 0 ? Vector3d(volume / 2 / height * normal) : Vector3d(Vector3d::Zero());
    }
};

std::vector<Surroundings> surroundings(const TriangleSheet& sheet, std::span<const double> thickness,
                                       std::span<const BoundaryEdge> boundary) {
    std::vector<Surroundings> around(sheet.points.size());
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const auto& corners = sheet.triangles[t];
        for (int k = 0; k < 3; ++k) {
            const Vector3d& p = sheet.points[corners[k]];
            const Vector3d e = sheet.points[corners[(k + 1) % 3]] - p,
                           f = sheet.points[corners[(k + 2) % 3]] - p, normal = e.cross(f);
            const double area = normal.norm();
            Surroundings& point = around[corners[k]];
            point.direction += angle_between(e, f) * normal.normalized();
            point.area_normal += normal;
            point.area += area;
            point.volume += area * thickness[t];
        }
    }
    for (const auto& [from, to, triangle, side] : boundary) {
        const auto& [a, b, c] = sheet.triangles[triangle];
        const Vector3d& p = sheet.points[a];
        const Vector3d normal = (sheet.points[b] - p).cross(sheet.points[c] - p);
        const Vector3d inward = normal.cross(sheet.points[to] - sheet.points[from]).normalized();
        around[from].inward += inward;
        around[to].inward += inward;
    }
    return around;
}

/// Points (m), each with the sums over the triangles around it.
struct Sides {
    std::vector<Vector3d> points;
    std::vector<Surroundings> around;

    bool touch(std::size_t a, std::size_t b) const {
        return (points[a] - points[b]).norm() < crack_width * around[a].thickness();
    }
    bool coincident(std::size_t a, std::size_t b) const {
        const double turn = angle_between(around[a].direction, around[b].direction);
        return touch(a, b) ? turn < largest_turn_touching
                           : turn < largest_turn &&
                                 (points[a] - points[b]).norm() < together_distance * around[a].thickness();
    }
    /// Returns the displacement of a boundary point, m, that moves both boundary edges at the point back by
    /// half the width of the gap.
    Vector3d retreat(std::size_t i) const {
        const Vector3d& inward = around[i].inward;
        const double length = std::max(inward.squaredNorm(), 1.0);
        return crack_width * around[i].thickness() * inward / length;
    }
};

/// Gives those of `points`, copies of one vertex, that lie together a common direction of offset. before: all
/// points as they were before treat_cracks().
void align(std::vector<std::size_t> points, const Sides& before, Sides& sides) {
    while (points.size() > 1) {
        const std::size_t first = points.front();
        const auto apart = std::stable_partition(points.begin(), points.end(), [&](std::size_t i) {
            return i == first || before.coincident(first, i);
        });
        Vector3d direction = Vector3d::Zero();
        for (auto i = points.begin(); i != apart; ++i) direction += before.around[*i].direction;
        for (auto i = points.begin(); i != apart; ++i) sides.around[*i].direction = direction;
        points.erase(points.begin(), apart);
    }
}

/// Moves each of `points`, copies of one vertex, that touches another of them back from the crack.
void part(std::span<const std::size_t> points, const Sides& before, Sides& sides) {
    for (const std::size_t i : points) {
        const bool touches =
            std::ranges::any_of(points, [&](std::size_t j) { return i != j && before.touch(i, j); });
        if (touches) sides.points[i] += before.retreat(i);
    }
}

void treat_cracks(std::span<const std::int32_t> origin, Sides& sides) {
    const Sides before = sides;
    std::map<std::int32_t, std::vector<std::size_t>> copies;
    for (std::size_t i = 0; i < origin.size(); ++i) copies[origin[i]].push_back(i);
    for (const auto& [number, points] : copies) {
        align(points, before, sides);
        part(points, before, sides);
    }
}

}  // namespace

TriangleSheet thickened(const TriangleSheet& sheet, std::span<const double> thickness,
                        std::span<const std::int32_t> origin) {
    const std::vector<BoundaryEdge> boundary = boundary_edges(sheet);
    Sides sides{sheet.points, surroundings(sheet, thickness, boundary)};
    treat_cracks(origin, sides);
    TriangleSheet body;
    const auto points = static_cast<std::int32_t>(sheet.points.size());
    for (const double side : {1.0, -1.0})
        for (std::int32_t i = 0; i < points; ++i)
            body.points.push_back(sides.points[i] + side * sides.around[i].offset());
    body.triangles = sheet.triangles;
    for (const auto& [a, b, c] : sheet.triangles)
        body.triangles.push_back({a + points, c + points, b + points});
    // For each triangle of the body, the triangle of the sheet whose properties it takes, and the numbers of
    // its corners in that triangle.
    std::vector<std::pair<std::size_t, std::array<int, 3>>> source;
    for (const auto& corners : {std::array{0, 1, 2}, std::array{0, 2, 1}})
        for (std::size_t t = 0; t < sheet.triangles.size(); ++t) source.emplace_back(t, corners);
    for (const auto& [from, to, triangle, side] : boundary) {
        // On both sides of a crack, the quadrilaterals along it are divided by the same diagonal; different
        // diagonals would intersect.
        const bool rising = origin.empty() || origin[to] < origin[from];
        body.triangles.push_back({to, from, rising ? from + points : to + points});
        body.triangles.push_back({rising ? to : from, from + points, to + points});
        const int next = (side + 1) % 3;
        source.emplace_back(triangle, std::array{next, side, rising ? side : next});
        source.emplace_back(triangle, std::array{rising ? next : side, side, next});
    }
    for (const auto& [t, corners] : source) {
        if (!sheet.group.empty()) body.group.push_back(sheet.group[t]);
        if (!sheet.quality.empty()) body.quality.push_back(sheet.quality[t]);
    }
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        const auto& values = sheet.look.*attribute.list;
        auto& list = body.look.*attribute.list;
        for (int side = 0; side < 2; ++side) list.insert(list.end(), values.begin(), values.end());
    });
    visit_attributes_of<Face>([&](const auto& attribute) {
        const auto& values = sheet.look.*attribute.list;
        if (values.empty()) return;
        for (const auto& [t, corners] : source)
            (body.look.*attribute.list).push_back(with_corners(values[t], corners));
    });
    body.shading.assign(2 * sheet.triangles.size(), Shading::smooth);
    body.shading.resize(body.triangles.size(), Shading::rim);
    body.group_names = sheet.group_names;
    return body;
}

}  // namespace sherd
