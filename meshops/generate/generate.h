// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/generate/polygon.h"
#include "meshops/mesh.h"

namespace sherd {

/// Layout of a generator's vertices.
enum class Layout {
    delaunay,   ///< unstructured, near-equilateral triangles: bending is nearly isotropic
    structured  ///< a regular grid with parallel diagonals, which bends anisotropically
};

struct GenerateOptions {
    double edge_length = 0.01;  ///< m, target length of edges
    Layout layout = Layout::delaunay;
    unsigned seed = 1;  ///< meshes of different seeds have the same shape and quality
};

/// Meshes the rectangle [0, width] x [0, height] (m) in the plane z = 0, with normals along +z.
Mesh generate_rectangle(double width, double height, const GenerateOptions& options);
/// Meshes a disc of `radius` (m) about the origin in the plane z = 0, with normals along +z.
Mesh generate_disc(double radius, const GenerateOptions& options);
/// Meshes an open tube of `radius` (m) about the z axis, 0 <= z <= height (m), with normals outward.
Mesh generate_cylinder(double radius, double height, const GenerateOptions& options);
/// Meshes a closed sphere of `radius` (m) about the origin, with normals outward.
Mesh generate_sphere(double radius, const GenerateOptions& options);
/// Meshes the surface of revolution about the z axis of a polyline, the profile, of (r, z) points (m) with r
/// >= 0, ordered from the axis (or the inner rim) outward. A point with r = 0 may only be the first or the
/// last, and closes the surface there. Normals point to the left of the direction of the profile in the (r,
/// z) half-plane: for a bowl drawn from its bottom to its rim, to its inside.
///
/// degrees: the surface is a sector about the z axis, from the angle 0 (the x axis) counterclockwise to
/// `degrees`. If this is below 360, the profile may not touch the axis, and the layout may be structured.
Mesh generate_revolution(std::span<const Eigen::Vector2d> profile, const GenerateOptions& options,
                         double degrees = 360);

/// Meshes a polygon in the plane z = 0, with normals along +z. Its lines (outline, holes and slits) have
/// vertices at corners where they turn by more than 20 degrees, and evenly spaced vertices between corners,
/// so that a curve may be given by many points. Along slits the mesh is open: vertices on slits are doubled,
/// except at ends inside the region.
Mesh generate_polygon(const Polygon& polygon, const GenerateOptions& options);

}  // namespace sherd
