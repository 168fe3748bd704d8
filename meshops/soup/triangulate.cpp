// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "meshops/error.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

using Corners = std::array<std::size_t, 3>;  // a triangle's corners, as indices of the polygon's corners
using Point2 = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel>;
using PolygonDelaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::Exact_predicates_tag>;

/// Returns the polygon, counterclockwise, projected along the coordinate axis nearest to its normal. In
/// contrast to a rotation into a plane, dropping a coordinate keeps collinear corners exactly collinear.
std::vector<Point2> flatten(const std::vector<Point>& polygon) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // by Newell's method
    const auto vector = [](const Point& p) { return Eigen::Vector3d(p.x(), p.y(), p.z()); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector3d a = vector(polygon[i]) - vector(polygon[0]);
        normal += a.cross(vector(polygon[(i + 1) % polygon.size()]) - vector(polygon[0]));
    }
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    std::vector<Point2> result;
    for (const Point& p : polygon) {
        const double x = p[(axis + 1) % 3], y = p[(axis + 2) % 3];
        result.push_back(normal[axis] >= 0 ? Point2(x, y) : Point2(y, x));
    }
    return result;
}

/// Returns the two triangles of a quadrilateral, divided along the shorter diagonal that lies inside; none if
/// no diagonal does.
std::vector<Corners> split_quadrilateral(const std::vector<Point>& polygon, const std::vector<Point2>& flat) {
    const auto is_inside = [&](std::size_t a) {
        const std::size_t b = (a + 1) % 4, c = a + 2, d = (a + 3) % 4;
        return CGAL::left_turn(flat[a], flat[b], flat[c]) && CGAL::left_turn(flat[a], flat[c], flat[d]);
    };
    const bool first = is_inside(0), second = is_inside(1);
    const bool is_first_shorter =
        CGAL::squared_distance(polygon[0], polygon[2]) <= CGAL::squared_distance(polygon[1], polygon[3]);
    if (first && (is_first_shorter || !second)) return {{0, 1, 2}, {0, 2, 3}};
    if (second) return {{0, 1, 3}, {1, 2, 3}};
    return {};
}

/// Number of sides of a polygon between each two vertices of its triangulation.
using SideCounts = std::map<std::array<PolygonDelaunay::Vertex_handle, 2>, int>;

/// Counts the sides of a polygon between vertices. Two sides between the same vertices, as along the bridge
/// to a hole, bound nothing.
SideCounts count_sides(const std::vector<PolygonDelaunay::Vertex_handle>& corner) {
    SideCounts counts;
    for (std::size_t i = 0; i < corner.size(); ++i) {
        const auto here = corner[i], next = corner[(i + 1) % corner.size()];
        ++counts[here < next ? std::array{here, next} : std::array{next, here}];
    }
    return counts;
}

/// Returns the faces of the triangulation that are inside the polygon: from outside they are reached across
/// an odd number of sides of the polygon.
std::vector<PolygonDelaunay::Face_handle> inner_faces(const PolygonDelaunay& triangulation,
                                                      const SideCounts& sides) {
    const auto bounds = [&](PolygonDelaunay::Face_handle face, int side) {
        const auto a = face->vertex(PolygonDelaunay::cw(side)), b = face->vertex(PolygonDelaunay::ccw(side));
        const auto found = sides.find(a < b ? std::array{a, b} : std::array{b, a});
        return found != sides.end() && found->second % 2 == 1;
    };
    std::map<PolygonDelaunay::Face_handle, bool> is_inner{{triangulation.infinite_face(), false}};
    std::vector<PolygonDelaunay::Face_handle> order{triangulation.infinite_face()};
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto face = order[i];
        for (int side = 0; side < 3; ++side) {
            const auto other = face->neighbor(side);
            const bool inner = is_inner[face] != bounds(face, side);
            if (is_inner.emplace(other, inner).second) order.push_back(other);
        }
    }
    std::erase_if(order, [&](auto face) { return !is_inner[face]; });
    return order;
}

/// Returns constrained Delaunay triangles of a polygon of five or more corners, which may have bridges to
/// holes; none if the polygon crosses itself. The first of several corners at the same place stands for all
/// of them.
std::vector<Corners> triangulate_flat(const std::vector<Point2>& flat) {
    PolygonDelaunay triangulation;
    std::vector<PolygonDelaunay::Vertex_handle> corner;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        const std::size_t before = triangulation.number_of_vertices();
        corner.push_back(triangulation.insert(flat[i]));
        if (triangulation.number_of_vertices() > before) corner.back()->info() = i;
    }
    if (triangulation.dimension() != 2) return {};
    // A side parallel to the axis that was dropped has no length in the plane; CGAL takes no such constraint.
    for (std::size_t i = 0; i < corner.size(); ++i)
        if (corner[i] == corner[(i + 1) % corner.size()]) return {};
    for (std::size_t i = 0; i < corner.size(); ++i) {
        triangulation.insert_constraint(corner[i], corner[(i + 1) % corner.size()]);
    }
    // A side that crosses another side, or passes through a corner, is divided there, and so is no edge.
    for (std::size_t i = 0; i < corner.size(); ++i)
        if (!triangulation.is_edge(corner[i], corner[(i + 1) % corner.size()])) return {};
    std::vector<Corners> result;
    for (const auto face : inner_faces(triangulation, count_sides(corner))) {
        Corners corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        result.push_back(corners);
    }
    std::ranges::sort(result);
    if (result.size() != flat.size() - 2) result.clear();
    return result;
}

std::vector<Corners> fan(std::size_t corners) {
    std::vector<Corners> result;
    for (std::size_t i = 1; i + 1 < corners; ++i) result.push_back({0, i, i + 1});
    return result;
}

/// Returns the triangles of a polygon; none if it crosses or touches itself.
std::vector<Corners> triangulate_simple(const std::vector<Point>& points) {
    if (points.size() <= 3) return fan(points.size());
    const auto is_on_line = [&](const Point& p) { return CGAL::collinear(points[0], points[1], p); };
    if (std::ranges::all_of(points, is_on_line)) return fan(points.size());
    const auto flat = flatten(points);
    return points.size() == 4 ? split_quadrilateral(points, flat) : triangulate_flat(flat);
}

std::vector<Corners> triangulate_polygon(const PolygonSoup& soup, std::size_t number) {
    const auto& polygon = soup.polygons[number];
    const std::size_t count = polygon.size();
    if (count <= 3) return fan(count);
    std::vector<Point> points;
    std::vector<std::size_t> kept;
    std::vector<Corners> result;
    for (std::size_t i = 0; i < count; ++i) {
        const Point &here = soup.points[polygon[i]], &next = soup.points[polygon[(i + 1) % count]];
        if (here == next) {
            // A repeated corner gives a side of length zero, with a triangle of zero area that is reported
            // later.
            result.push_back({(i + count - 1) % count, i, (i + 1) % count});
        } else {
            kept.push_back(i);
            points.push_back(here);
        }
    }
    if (kept.size() < 3) return fan(count);
    const auto simple = triangulate_simple(points);
    if (simple.empty()) {
        throw Error(place_of_polygon(soup, number) + ": the polygon of " + std::to_string(count) +
                    " corners crosses or touches itself; cut it into triangles before it is read");
    }
    for (const auto& [a, b, c] : simple) result.push_back({kept[a], kept[b], kept[c]});
    return result;
}

FaceTexture texture_of(const PolygonSoup& soup, std::size_t polygon, const Corners& corners) {
    const auto& texture = soup.texture[polygon];
    if (texture.empty()) return {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    return {texture[corners[0]], texture[corners[1]], texture[corners[2]]};
}

}  // namespace

TriangleSoup triangulate(const PolygonSoup& soup) {
    TriangleSoup result;
    result.points = soup.points;
    for (std::uint32_t i = 0; i < soup.points.size(); ++i) result.file_vertex.push_back(i);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        for (const Corners& corners : triangulate_polygon(soup, i)) {
            auto& triangle = result.triangles.emplace_back();
            for (int k = 0; k < 3; ++k) {
                triangle[k] = static_cast<std::uint32_t>(soup.polygons[i][corners[k]]);
            }
            result.polygon.push_back(i);
            if (!soup.texture.empty()) result.texture.push_back(texture_of(soup, i, corners));
        }
    }
    return result;
}

}  // namespace sherd
