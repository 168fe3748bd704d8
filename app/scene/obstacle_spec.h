// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/scene/mesh_spec.h"
#include "core/contact/geometry/basic_shapes.h"
#include "core/motion.h"

namespace sherd {

/// `cache = "hand.pc2"`: the motion of the vertices of a mesh.
struct ObstacleCache {
    std::filesystem::path path;             ///< relative to the working directory
    double start = 0;                       ///< s, time of the first sample
    std::optional<double> frame_rate = {};  ///< 1/s; none: as the file says, or 24
    bool smooth = true;                     ///< see Deformation
    std::string where = {};                 ///< "FILE:LINE: dotted.key", for errors
};

/// `mesh = "anvil.obj"` of an obstacle: a closed mesh, from which a grid of distances is made, or with a
/// cache any mesh, which deforms.
struct ObstacleMesh {
    MeshFile file;
    double voxel = 0;  ///< m; 0: from the mesh's size
    std::optional<ObstacleCache> cache = {};
};

/// `vdb = "anvil.vdb"`: a level set.
struct ObstacleLevelSet {
    std::filesystem::path path;  ///< relative to the working directory
    std::string name;            ///< name of the grid; empty: the only one
    double scale = 1;            ///< metres per unit of the file
};

/// Further data of an obstacle that moves freely.
struct FreeMotion {
    double density = 0;                    ///< kg/m^3; 0: from the mass
    double mass = 0;                       ///< kg, of a mesh without density
    Vector3d velocity = Vector3d::Zero();  ///< m/s, at the start
    Vector3d spin = Vector3d::Zero();      ///< rad/s, at the start, about its centre
};

/// `[obstacle.NAME]`.
struct ObstacleSpec {
    std::string name;
    /// Shape before it is placed.
    std::variant<PlaneShape, SphereShape, BoxShape, CylinderShape, ObstacleMesh, ObstacleLevelSet> shape;
    Motion motion;
    std::optional<FreeMotion> free;  ///< spheres, boxes and meshes only; none: prescribed motion
    double friction = 0;
    double young = 3e10;  ///< Pa, by default of concrete, C20/25 of EN 1992-1-1, as most floors
    std::string where;    ///< "FILE:LINE: dotted.key" of its shape, for errors
};

/// The cache by which an obstacle deforms; null: it is rigid.
inline const ObstacleCache* cache_of(const ObstacleSpec& obstacle) {
    const auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape);
    return mesh != nullptr && mesh->cache ? &*mesh->cache : nullptr;
}

}  // namespace sherd
