// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "meshops/mesh.h"

namespace sherd::test {

/// Quality of the triangles of a mesh. Angles are in degrees, lengths in m, areas in m^2.
struct MeshQuality {
    double smallest_angle = 180;
    double mean_smallest_angle = 0;
    double mean_edge = 0;
    double area = 0;
    /// |mean of exp(6 i angle)| over the inner edges, whose angles are in the xy plane: 1 for a lattice of
    /// equilateral triangles, 0 for edges in random directions.
    double order = 0;
};

inline double corner_degrees(const Mesh& mesh, Halfedge h) {
    const auto u = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h));
    const auto v = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
    const double sine = std::sqrt(CGAL::cross_product(u, v).squared_length());
    return std::atan2(sine, u * v) * 180 / std::numbers::pi;
}

inline double face_area(const Mesh& mesh, Face face) {
    const Halfedge h = mesh.halfedge(face);
    const auto u = mesh.point(mesh.source(h)) - mesh.point(mesh.target(h));
    const auto v = mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.target(h));
    return std::sqrt(CGAL::cross_product(u, v).squared_length()) / 2;
}

inline MeshQuality mesh_quality(const Mesh& mesh) {
    MeshQuality quality;
    for (const Face face : mesh.faces()) {
        double smallest = 180;
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            smallest = std::min(smallest, corner_degrees(mesh, h));
        }
        quality.smallest_angle = std::min(quality.smallest_angle, smallest);
        quality.mean_smallest_angle += smallest / mesh.number_of_faces();
        quality.area += face_area(mesh, face);
    }
    std::complex<double> order = 0;
    double inner = 0;
    for (const Edge edge : mesh.edges()) {
        const auto way = mesh.point(mesh.vertex(edge, 1)) - mesh.point(mesh.vertex(edge, 0));
        quality.mean_edge += std::sqrt(way.squared_length()) / mesh.number_of_edges();
        if (mesh.is_border(edge)) continue;
        order += std::polar(1.0, 6 * std::atan2(way.y(), way.x()));
        ++inner;
    }
    quality.order = std::abs(order) / inner;
    return quality;
}

}  // namespace sherd::test
