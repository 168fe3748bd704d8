// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/scene/mesh_spec.h"
#include "core/contact/geometry/basic_shapes.h"
#include "core/motion.h"

namespace sherd {

/// `cache = "hand.pc2"`: where the vertices of a mesh go.
struct ObstacleCache {
    std::filesystem::path path;             ///< as seen from the working directory
    double start = 0;                       ///< s, when its first sample is
    std::optional<double> frame_rate = {};  ///< 1/s; none: as the file says, or 24
    bool smooth = true;                     ///< as of Deformation
    std::string where = {};                 ///< "FILE:LINE: dotted.key", for errors
};

/// `mesh = "anvil.obj"` of an obstacle: a closed mesh, which a grid is made of, or with a cache any mesh,
/// that deforms.
struct ObstacleMesh {
    MeshFile file;
    double voxel = 0;  ///< m; 0: a part of the mesh's size
    std::optional<ObstacleCache> cache = {};
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
    double young = 3e10;  ///< Pa, of what it is made of: concrete, C20/25 of EN 1992-1-1, as most floors
    std::string where;    ///< "FILE:LINE: dotted.key" of its shape, for errors
};

/// The cache that an obstacle deforms by; null: it is rigid.
inline const ObstacleCache* cache_of(const ObstacleSpec& obstacle) {
    const auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape);
    return mesh != nullptr && mesh->cache ? &*mesh->cache : nullptr;
}

}  // namespace sherd
