// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/vector.h"
#include "meshops/generate/polygon.h"
#include "meshops/remesh/remesh.h"

namespace sherd {

/// A generated mesh: `mesh = { generate = "plate", radius = 0.13, edge_length = 0.004 }`.
struct GeneratedMesh {
    std::string shape;       ///< rectangle, disc, cylinder, sphere, plate, bowl, revolution,
                             ///< polygon
    double edge_length = 0;  ///< m
    bool structured = false;
    double width = 0, height = 0, radius = 0;  ///< m, where the shape has them
    std::vector<Vector2d> profile;             ///< (r, z) in m, for a plate, bowl or revolution
    double foot = 0;                           ///< m, radius out to which a plate is flat
    double cap_degrees = 60;  ///< degrees from the bottom to the rim of a bowl, seen from its sphere's
                              ///< centre, unless a height is given
    double angle = 360;       ///< degrees of revolution: less than 360 for a sector
    Polygon polygon;          ///< outline, holes and slits of the shape "polygon"
};

/// A mesh from a file: `mesh = "bowl.obj"` or `mesh = { file = "bowl.obj", remesh = 0.005 }`.
struct MeshFile {
    std::filesystem::path path;  ///< relative to the working directory
    bool repair = true;          ///< whether unambiguous defects are repaired; if not, they are errors
    bool join = false;           ///< whether duplicate points are joined
    double join_distance = 0;    ///< m; if positive, points of the boundary within this distance are joined,
                                 ///< too
    double scale = 1;            ///< metres per unit of the file; computed from `size` if that is given
    bool has_size = false;       ///< whether the scene says `scale` or `size`
    std::optional<RemeshOptions> remesh;  ///< none: the file's mesh is not remeshed
};

/// A mesh that a program passes as plain arrays.
struct GivenMesh {
    std::vector<Vector3d> positions;                 ///< [V] m
    std::vector<std::array<std::int32_t, 3>> faces;  ///< [F] three vertices of each face, counterclockwise
};
using GivenMeshes = std::map<std::string, GivenMesh>;  ///< meshes by their names

/// A mesh that a program passes: `mesh = { given = "bowl" }`. Its vertices and faces keep their numbers
/// unless it is remeshed.
struct GivenMeshName {
    std::string name;
    std::optional<RemeshOptions> remesh = {};  ///< none: the given mesh is not remeshed
};

/// Largest number of faces that a scene may ask for; more are most likely due to a mistyped edge length.
inline constexpr double most_faces = 5e6;

/// Returns the number of faces of an equilateral mesh of `area` (m^2) with edges of `edge_length` (m).
double expected_faces(double area, double edge_length);

}  // namespace sherd
