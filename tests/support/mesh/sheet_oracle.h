// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "meshops/read_write/write_mesh.h"
#include "meshops/repair/triangle_mesh.h"
#include "meshops/topology/topology_change.h"

namespace sherd::test {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Mesh as plain arrays, for reference computations without halfedges.
inline TriangleSheet arrays_of(const Mesh& mesh) {
    return triangle_sheet(mesh);
}

inline Corners corners_of(const TriangleSheet& sheet, std::size_t face) {
    const auto& [a, b, c] = sheet.triangles[face];
    return {sheet.points[a], sheet.points[b], sheet.points[c]};
}

inline double area_of(const Corners& p) {
    return (p[1] - p[0]).cross(p[2] - p[0]).norm() / 2;
}

/// Smallest angle by the law of cosines, degrees.
inline double smallest_angle_of(const Corners& p) {
    double smallest = 180;
    for (int i = 0; i < 3; ++i) {
        const double a = (p[(i + 1) % 3] - p[i]).norm(), b = (p[(i + 2) % 3] - p[i]).norm();
        const double c = (p[(i + 1) % 3] - p[(i + 2) % 3]).norm();
        const double cosine = std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.0, 1.0);
        smallest = std::min(smallest, std::acos(cosine) * 180 / std::numbers::pi);
    }
    return smallest;
}

/// Distance of a point from a triangle, by its nearest part: the inside, a side or a corner.
inline double distance_to(const Corners& p, const Eigen::Vector3d& x) {
    const Eigen::Vector3d normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    bool is_above = true;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d side = p[(i + 1) % 3] - p[i], way = x - p[i];
        is_above = is_above && normal.cross(side).dot(way) >= 0;
        const double t = std::clamp(way.dot(side) / side.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (way - t * side).norm());
    }
    return is_above ? std::abs(normal.dot(x - p[0])) : least;
}

/// V - E + F, with edges counted from the triangles.
inline long euler_characteristic(const TriangleSheet& sheet) {
    std::set<std::pair<int, int>> edges;
    for (const auto& t : sheet.triangles)
        for (int i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    return static_cast<long>(sheet.points.size()) - static_cast<long>(edges.size()) +
           static_cast<long>(sheet.triangles.size());
}

/// Expects that every vertex of `change` has at most three parents, with weights whose sum is 1 and which
/// give the vertex's position.
inline void expect_places(const TriangleSheet& old, const TriangleSheet& now, const TopologyChange& change,
                          double round_off) {
    std::set<std::size_t> placed;
    for (const auto* vertices : {&change.vertices, &change.moved})
        for (const WithParents<Vertex>& vertex : *vertices) {
            Eigen::Vector3d place = Eigen::Vector3d::Zero();
            double sum = 0;
            EXPECT_LE(vertex.parents.size(), 3u);
            for (const auto& [parent, weight] : vertex.parents) {
                ASSERT_LT(parent.idx(), old.points.size());
                EXPECT_GE(weight, 0);
                place += weight * old.points[parent.idx()];
                sum += weight;
            }
            EXPECT_NEAR(sum, 1, 1e-14);
            EXPECT_LE((place - now.points[vertex.element.idx()]).norm(), round_off);
            double distance = std::numeric_limits<double>::infinity();
            for (std::size_t f = 0; f < old.triangles.size(); ++f)
                distance = std::min(distance, distance_to(corners_of(old, f), place));
            EXPECT_LE(distance, round_off) << "off the old surface";
            placed.insert(vertex.element.idx());
        }
    for (std::size_t v = 0; v < now.points.size(); ++v)
        EXPECT_TRUE(placed.contains(v) || now.points[v] == old.points[v]) << v;
}

/// Expects that the new faces of `change` cover the old faces: the shares of each old face in new ones sum to
/// 1, and faces that `change` does not name stay as they are. On a flat sheet the area of each new face must
/// be the sum of its shares of old faces' areas.
inline void expect_areas(const TriangleSheet& old, const TriangleSheet& now, const TopologyChange& change,
                         bool is_flat) {
    std::map<std::size_t, double> passed_on;
    std::set<std::size_t> reshaped;
    double whole = 0;
    for (std::size_t f = 0; f < old.triangles.size(); ++f) whole += area_of(corners_of(old, f));
    const double mean = whole / static_cast<double>(old.triangles.size());
    for (const auto& [face, shares] : change.reshaped) {
        reshaped.insert(face.idx());
        double received = 0;
        for (const auto& [parent, share] : shares) {
            passed_on[parent.idx()] += share;
            received += share * area_of(corners_of(old, parent.idx()));
        }
        if (is_flat) {
            EXPECT_NEAR(received / mean, area_of(corners_of(now, face.idx())) / mean, 1e-12);
        }
    }
    for (const auto& [face, sum] : passed_on) EXPECT_NEAR(sum, 1, 1e-12);
    for (const Face face : change.changed) EXPECT_TRUE(passed_on.contains(face.idx()));
    EXPECT_EQ(passed_on.size(), change.changed.size());
    for (std::size_t f = 0; f < now.triangles.size(); ++f)
        EXPECT_TRUE(reshaped.contains(f) || now.triangles[f] == old.triangles[f]) << f;
    EXPECT_EQ(reshaped.size(), change.changed.size() + change.faces.size());
    EXPECT_EQ(now.triangles.size(), old.triangles.size() + change.faces.size());
}

/// Expects that the mesh is an oriented manifold, both as it is and rebuilt from its arrays, with the Euler
/// characteristic of the old mesh.
inline void expect_manifold(const TriangleSheet& old, const Mesh& mesh, const TriangleSheet& now) {
    EXPECT_TRUE(mesh.is_valid(false));
    EXPECT_NO_THROW(triangle_mesh(now.points, now.triangles));
    EXPECT_EQ(euler_characteristic(now), euler_characteristic(old));
}

/// Expects what holds for every change of a sheet's triangles. old: the sheet before the change; mesh: after
/// it.
inline void expect_same_sheet(const TriangleSheet& old, const Mesh& mesh, const TopologyChange& change,
                              bool is_flat) {
    const TriangleSheet now = arrays_of(mesh);
    double size = 0;
    for (const Eigen::Vector3d& point : old.points) size = std::max(size, point.norm());
    expect_manifold(old, mesh, now);
    expect_places(old, now, change, 1e-13 * size);
    expect_areas(old, now, change, is_flat);
}

}  // namespace sherd::test
