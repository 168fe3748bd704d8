// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "core/vector.h"
#include "meshops/attributes.h"
#include "meshops/surface_material.h"

namespace sherd {

/// Points with their normals.
struct GlbShape {
    std::vector<Vector3d> points, normals;
};

/// A node of the file with a mesh, which may move or change its shape.
struct GlbNode {
    std::string name;
    bool obstacle = false;  ///< whether it has the material of obstacles instead of that of sheets
    std::vector<std::array<Index, 3>> triangles = {};
    std::vector<FaceMaterial> material = {};    ///< material of each triangle; empty: none
    std::vector<Eigen::Vector2d> texture = {};  ///< [P] texture coordinates, v upwards; empty: none
    std::vector<Colour> colour = {};            ///< [P]; empty: none
    /// Further numbers of the points, [P] each, by name; in the file the names begin with an underscore.
    std::map<std::string, std::vector<double>> numbers = {};
    std::vector<GlbShape> shapes = {};            ///< a single shape, or a shape for each time
    std::vector<Eigen::Isometry3d> motions = {};  ///< to space: a single motion, or a motion for each time
};

/// Content of a .glb file. Lengths are in m, and z is up (in glTF y is up: a root node turns all others).
struct GlbScene {
    std::string name;
    bool double_sided = true;   ///< whether sheets are seen from both sides
    std::vector<double> times;  ///< s, ascending, from 0
    std::vector<GlbNode> nodes;
};

/// Returns the content of a binary glTF 2.0 file. Nodes with several motions get an animation of translation
/// and rotation, and nodes with several shapes get a morph target for each shape but the first. Pictures of
/// materials, .png or .jpg, are embedded; `warnings` gets a sentence for each picture that cannot be.
std::string glb_bytes(const GlbScene& scene, std::vector<std::string>& warnings);

}  // namespace sherd
