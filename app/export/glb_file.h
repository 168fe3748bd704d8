// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/vector.h"
#include "meshops/surface_colour.h"
#include "meshops/surface_material.h"

namespace sherd {

/// Points with their normals.
struct GlbShape {
    std::vector<Vector3d> points, normals;
};

/// A node with a mesh of its own, that moves, or changes its shape, or does neither.
struct GlbNode {
    std::string name;
    bool obstacle = false;  ///< has the material of obstacles instead of that of sheets
    std::vector<std::array<Index, 3>> triangles = {};
    std::vector<FaceMaterial> material = {};      ///< of each triangle; empty: none has one
    std::vector<Eigen::Vector2d> texture = {};    ///< of each point, v upwards; empty: none
    std::vector<Colour> colour = {};              ///< of each point; empty: none
    std::vector<GlbShape> shapes = {};            ///< [1] or one for each time
    std::vector<Eigen::Isometry3d> motions = {};  ///< [1] or one for each time
};

/// Holds what a .glb file says. Lengths are in m, and z is up (glTF has y up: one node above all others turns
/// them).
struct GlbScene {
    std::string name;
    bool double_sided = true;   ///< its sheets, seen from both sides
    std::vector<double> times;  ///< s, rising, from 0
    std::vector<GlbNode> nodes;
};

/// Returns the content of a binary glTF 2.0 file. Nodes whose motion has several values get an animation of
/// translation and rotation, and those with several shapes get a morph target for each but the first.
/// Pictures of materials, .png or .jpg, are part of it; `warnings` gets a sentence for each that cannot be.
std::string glb_bytes(const GlbScene& scene, std::vector<std::string>& warnings);

}  // namespace sherd
