// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/scene/mesh_spec.h"
#include "core/contact/geometry/basic_shapes.h"
#include "core/motion.h"

namespace sherd {

/// `mesh = "anvil.obj"` of an obstacle: a closed mesh, which a grid is made of.
struct ObstacleMesh {
    MeshFile file;
    double voxel = 0;  ///< m; 0: a part of the mesh's size
};

/// `vdb = "anvil.vdb"`: a level set.
struct ObstacleLevelSet {
    std::filesystem::path path;  ///< as seen from the working directory
    std::string name;            ///< of the grid; empty: the only one
    double scale = 1;            ///< metres per unit of the file
};

/// What an obstacle that is free to move has besides.
struct FreeMotion {
    double density = 0;                    ///< kg/m^3; 0: by the mass
    double mass = 0;                       ///< kg, of a mesh without density
    Vector3d velocity = Vector3d::Zero();  ///< m/s, at the start
    Vector3d spin = Vector3d::Zero();      ///< rad/s, at the start, about its centre
};

/// `[obstacle.NAME]`.
struct ObstacleSpec {
    std::string name;
    /// Before it is placed.
    std::variant<PlaneShape, SphereShape, BoxShape, CylinderShape, ObstacleMesh, ObstacleLevelSet> shape;
    Motion motion;
    std::optional<FreeMotion> free;  ///< a sphere's, a box's or a mesh's; none: it moves by its keys only
    double friction = 0;
    double young = 0;   ///< Pa, of what it is made of
    std::string where;  ///< "FILE:LINE: dotted.key" of its shape, for errors
};

}  // namespace sherd
