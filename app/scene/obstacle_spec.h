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
    std::optional<double> frame_rate = {};  ///< frames of a .pc2 file, or samples of an .mdd file, per
                                            ///< second; none: 24, or the times in the file
    bool smooth = true;                     ///< see Deformation::smooth
    std::string where = {};                 ///< "FILE:LINE: dotted.key", for errors
};

/// `mesh = "anvil.obj"` of an obstacle: a closed mesh, from which a grid of signed distances is made; or any
/// mesh with a cache, by which it deforms.
struct ObstacleMesh {
    MeshFile file;
    double voxel = 0;  ///< m, size of the grid's voxels; 0: computed from the mesh's size
    std::optional<ObstacleCache> cache = {};
};

/// `vdb = "anvil.vdb"`: a level set.
struct ObstacleLevelSet {
    std::filesystem::path path;  ///< relative to the working directory
    std::string name;            ///< name of the grid; empty: the file's only one
    double scale = 1;            ///< metres per unit of the file
};

/// Further data of an obstacle that moves freely.
struct FreeMotion {
    double density = 0;                    ///< kg/m^3; 0: computed from the mass
    double mass = 0;                       ///< kg, used for a mesh without a density
    Vector3d velocity = Vector3d::Zero();  ///< m/s, initial velocity
    Vector3d spin = Vector3d::Zero();      ///< rad/s, initial angular velocity, about the centre of mass
};

/// An obstacle of a scene: `[obstacle.NAME]`.
struct ObstacleSpec {
    std::string name;
    /// Shape before it is placed.
    std::variant<PlaneShape, SphereShape, BoxShape, CylinderShape, ObstacleMesh, ObstacleLevelSet> shape;
    Motion motion;
    std::optional<FreeMotion> free;  ///< for spheres, boxes and meshes only; none: the obstacle does not move
                                     ///< freely, but by `motion`
    double friction = 0;
    double young = 3e10;  ///< Pa; by default that of the concrete C20/25 of EN 1992-1-1, as of most floors
    std::string where;    ///< "FILE:LINE: dotted.key" of its shape, for errors
};

/// Returns the cache by which an obstacle deforms; null: it is rigid.
inline const ObstacleCache* cache_of(const ObstacleSpec& obstacle) {
    const auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape);
    return mesh != nullptr && mesh->cache ? &*mesh->cache : nullptr;
}

}  // namespace sherd
