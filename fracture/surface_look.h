// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "meshops/mesh.h"
#include "meshops/surface_colour.h"
#include "meshops/surface_material.h"

namespace sherd {

/// Texture coordinates of faces: columns u0 v0 u1 v1 u2 v2 of the three corners.
using CornerTexture = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// How a mesh at rest looks, as far as its file says it.
struct SurfaceLook {
    CornerTexture texture = {};        ///< [6, F]; empty: none
    std::vector<Index> material = {};  ///< [F] rows of materials, -1: none; empty: no face has one
    std::vector<SurfaceMaterial> materials = {};
    std::vector<Index> group = {};  ///< [F] rows of groups, -1: in none; empty: no face is in one
    std::vector<std::vector<std::string>> groups = {};  ///< names of groups and objects that faces share
    std::vector<Colour> face_colour = {};               ///< [F]; empty: none
    std::vector<Colour> vertex_colour = {};             ///< [R] of its vertices; empty: none

    bool operator==(const SurfaceLook& other) const;
    void visit_state(StateVisitor& visit);
    bool has_colours() const { return !face_colour.empty() || !vertex_colour.empty(); }
    /// Whether it says how anything is painted.
    bool paints() const { return !materials.empty() || has_colours(); }
    /// That of the vertex at rest, or else of the face; white without colours.
    Colour colour(std::size_t face, Index vertex) const;
};

/// Visits materials, which know nothing of states.
void visit_materials(StateVisitor& visit, std::vector<SurfaceMaterial>& materials);

/// original: [V] vertex at rest of each vertex of the mesh, all below `count`.
SurfaceLook surface_look(const Mesh& mesh, std::span<const Index> original, std::size_t count);

/// Gives a mesh that others will be joined to the properties of looks that any of them has: texture
/// coordinates (0, 0), no material and white where there are none.
void take_looks(Mesh& mesh, const Mesh& of);

}  // namespace sherd
