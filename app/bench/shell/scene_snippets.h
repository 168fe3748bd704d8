// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vector.h"

namespace sherd {

// Parts of the TOML of a benchmark's scene. A mesh is to get the length of its edges where it says MESH.

/// Planes of symmetry x = 0 and y = 0, and z = 0, too.
inline constexpr const char* planes_x_y =
    "symmetry = [{ point = [0, 0, 0], normal = [0, 1, 0] }, "
    "{ point = [0, 0, 0], normal = [1, 0, 0] }]\n";
inline constexpr const char* planes_x_y_z =
    "symmetry = [{ point = [0, 0, 0], normal = [0, 1, 0] }, "
    "{ point = [0, 0, 0], normal = [1, 0, 0] }, "
    "{ point = [0, 0, 0], normal = [0, 0, 1] }]\n";

/// A clamp along the y axis.
inline constexpr const char* clamp_at_y_axis = "clamp = { box = [[-1, -1, -1], [1e-6, 2, 1]] }\n";

std::string box(const Vector3d& lower, const Vector3d& upper);
/// A box that catches the vertex at p.
std::string box_at(const Vector3d& p);
/// A force on the vertex at p.
std::string force_at(const Vector3d& p, const Vector3d& force);
std::string gauge_at(const std::string& name, const Vector3d& p);

/// Isotropic, of density 1.
std::string material(double thickness, double young, double poisson);
/// A plate of rigidity 1, 0.01 thick, of density 1. Loads that are `small` move one of size 1 by far less
/// than its thickness: theory is linear.
inline constexpr double plate_thickness = 0.01, plate_poisson = 0.3, small = 1e-2;
double young_of_unit_plate(double poisson);
std::string unit_plate(double poisson = plate_poisson);

std::string rectangle(double width, double height);
/// profile: TOML of its points; angle: degrees.
std::string revolution(const std::string& profile, double angle);
/// The profile from (r0, z0) to (r1, z1).
std::string line(double r0, double z0, double r1, double z1);
/// The profile of a sphere's sector, counted from the top.
std::string arc(double radius, double from_degrees, double to_degrees);

}  // namespace sherd
