// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "meshops/mesh.h"

namespace sherd {

inline Eigen::Vector3d position(const Mesh& mesh, Vertex v) {
    const Point& p = mesh.point(v);
    return {p.x(), p.y(), p.z()};
}

Eigen::Vector3d centroid(const Mesh& mesh, Face face);  ///< m
double face_area(const Mesh& mesh, Face face);          ///< m^2

/// Sizes of a mesh with at least one face: area in m^2, lengths in m.
struct MeshMeasures {
    double area = 0;
    double smallest_edge = 0, mean_edge = 0, largest_edge = 0;
    Eigen::Vector3d lower, upper;  ///< corners of the bounding box
    int boundary_loops = 0;
};

MeshMeasures measure(const Mesh& mesh);

}  // namespace sherd
