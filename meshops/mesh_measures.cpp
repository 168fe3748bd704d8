// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/mesh_measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sherd {
namespace {

int count_boundary_loops(const Mesh& mesh) {
    std::vector<bool> seen(mesh.number_of_halfedges(), false);
    int loops = 0;
    for (const Halfedge start : mesh.halfedges()) {
        if (!mesh.is_border(start) || seen[start]) continue;
        ++loops;
        for (Halfedge h = start; !seen[h]; h = mesh.next(h)) seen[h] = true;
    }
    return loops;
}

}  // namespace

Eigen::Vector3d centroid(const Mesh& mesh, Face face) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) sum += position(mesh, v);
    return sum / 3;
}

double face_area(const Mesh& mesh, Face face) {
    const Halfedge h = mesh.halfedge(face);
    const Eigen::Vector3d a = position(mesh, mesh.source(h)), b = position(mesh, mesh.target(h));
    const Eigen::Vector3d c = position(mesh, mesh.target(mesh.next(h)));
    return (b - a).cross(c - a).norm() / 2;
}

std::array<Vertex, 3> face_corners(const Mesh& mesh, Face face) {
    const Halfedge h = mesh.halfedge(face);
    return {mesh.target(h), mesh.target(mesh.next(h)), mesh.source(h)};
}

std::array<Eigen::Vector3d, 3> face_points(const Mesh& mesh, Face face) {
    const auto [a, b, c] = face_corners(mesh, face);
    return {position(mesh, a), position(mesh, b), position(mesh, c)};
}

Eigen::Vector3d triangle_normal(const std::array<Eigen::Vector3d, 3>& corners) {
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}

double smallest_angle(const std::array<Eigen::Vector3d, 3>& corners) {
    const double doubled_area = triangle_normal(corners).norm();
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d u = corners[(i + 1) % 3] - corners[i], v = corners[(i + 2) % 3] - corners[i];
        smallest = std::min(smallest, std::atan2(doubled_area, u.dot(v)));
    }
    return smallest;
}

double mean_edge_at(const Mesh& mesh, Vertex vertex) {
    double sum = 0;
    int count = 0;
    for (const Vertex other : mesh.vertices_around_target(mesh.halfedge(vertex))) {
        sum += (position(mesh, other) - position(mesh, vertex)).norm();
        ++count;
    }
    return sum / count;
}

MeshMeasures measure(const Mesh& mesh) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    MeshMeasures measures;
    measures.smallest_edge = infinity;
    measures.lower.setConstant(infinity);
    measures.upper.setConstant(-infinity);
    for (const Vertex v : mesh.vertices()) {
        measures.lower = measures.lower.cwiseMin(position(mesh, v));
        measures.upper = measures.upper.cwiseMax(position(mesh, v));
    }
    for (const Edge e : mesh.edges()) {
        const double length = (position(mesh, mesh.vertex(e, 1)) - position(mesh, mesh.vertex(e, 0))).norm();
        measures.smallest_edge = std::min(measures.smallest_edge, length);
        measures.largest_edge = std::max(measures.largest_edge, length);
        measures.mean_edge += length / static_cast<double>(mesh.number_of_edges());
    }
    measures.smallest_angle = infinity;
    for (const Face f : mesh.faces()) {
        measures.area += face_area(mesh, f);
        measures.smallest_angle = std::min(measures.smallest_angle, smallest_angle(face_points(mesh, f)));
    }
    measures.boundary_loops = count_boundary_loops(mesh);
    return measures;
}

}  // namespace sherd
