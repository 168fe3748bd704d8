// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vector.h"

namespace sherd {

// Snippets of TOML for the scene of a benchmark. MESH stands in place of the keys of a mesh that differ
// between variants of the scene: see scene_text().

/// Planes of symmetry x = 0 and y = 0; in planes_x_y_z also z = 0.
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
/// A small box around p, which contains the vertex there.
std::string box_at(const Vector3d& p);
/// A force on the vertex at p.
std::string force_at(const Vector3d& p, const Vector3d& force);
std::string gauge_at(const std::string& name, const Vector3d& p);

/// An isotropic material of density 1.
std::string material(double thickness, double young, double poisson);
/// Thickness and Poisson's ratio of unit_plate(), a plate of rigidity 1 and density 1, and a size of loads
/// that deflect this plate by far less than its thickness if its side is 1, so that the linear theory holds.
inline constexpr double plate_thickness = 0.01, plate_poisson = 0.3, small = 1e-2;
double young_of_unit_plate(double poisson);
std::string unit_plate(double poisson = plate_poisson);

std::string rectangle(double width, double height);
/// The mesh of a surface of revolution. profile: its points (r, z) as TOML; angle: degrees.
std::string revolution(const std::string& profile, double angle);
/// A straight profile from (r0, z0) to (r1, z1).
std::string line(double r0, double z0, double r1, double z1);
/// A profile of a sphere about the origin, between two angles from the z axis.
std::string arc(double radius, double from_degrees, double to_degrees);

}  // namespace sherd
