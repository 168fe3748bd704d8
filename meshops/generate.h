// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/mesh.h"

namespace sherd {

/// How a generator places its vertices.
enum class Layout {
    delaunay,   ///< unstructured, near-equilateral triangles (a sheet of them bends alike in all directions)
    structured  ///< a regular grid with parallel diagonals; bends anisotropically, on request only
};

struct GenerateOptions {
    double edge_length = 0.01;  ///< m, target
    Layout layout = Layout::delaunay;
    unsigned seed = 1;  ///< another seed gives another mesh of the same shape and quality
};

/// Rectangle [0, width] x [0, height] in the plane z = 0, normals along +z.
Mesh generate_rectangle(double width, double height, const GenerateOptions& options);
/// Disc of `radius` about the origin in the plane z = 0, normals along +z.
Mesh generate_disc(double radius, const GenerateOptions& options);
/// Open tube of `radius` about the z axis, 0 <= z <= height, normals outward.
Mesh generate_cylinder(double radius, double height, const GenerateOptions& options);
/// Closed sphere about the origin, normals outward.
Mesh generate_sphere(double radius, const GenerateOptions& options);
/// Surface of revolution about the z axis of a polyline of (r, z) points with r >= 0, ordered from the axis
/// (or inner rim) outward; a point with r = 0 can only be the first or the last and closes the surface there.
/// Normals point to the left of the profile's direction of travel in the (r, z) half plane: a bowl drawn from
/// its bottom to its rim has them inside.
Mesh generate_revolution(std::span<const Eigen::Vector2d> profile, const GenerateOptions& options);

}  // namespace sherd
