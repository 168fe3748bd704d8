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

/// Appearance of a mesh at rest, as far as its file specifies it.
struct SurfaceLook {
    CornerTexture texture = {};        ///< [6, F]; empty: none
    std::vector<Index> material = {};  ///< [F] index into materials, -1: none; empty: no face has one
    std::vector<SurfaceMaterial> materials = {};
    std::vector<Index> group = {};  ///< [F] index into groups, -1: in none; empty: no face is in one
    std::vector<std::vector<std::string>> groups = {};  ///< names of the groups and objects of a face
    std::vector<Colour> face_colour = {};               ///< [F]; empty: none
    std::vector<Colour> vertex_colour = {};             ///< [R]; empty: none

    bool operator==(const SurfaceLook& other) const;
    void visit_state(StateVisitor& visit);
    bool has_colours() const { return !face_colour.empty() || !vertex_colour.empty(); }
    /// Whether there are materials or colours.
    bool paints() const { return !materials.empty() || has_colours(); }
    /// The colour of the vertex at rest, or else of the face; white without colours.
    Colour colour(std::size_t face, Index vertex) const;
};

/// Visits materials, which have no visit_state().
void visit_materials(StateVisitor& visit, std::vector<SurfaceMaterial>& materials);

/// Returns the appearance of a mesh. original: [V] vertex at rest of each vertex of the mesh, all below
/// `count`.
SurfaceLook surface_look(const Mesh& mesh, std::span<const Index> original, std::size_t count);

/// Adds to a mesh, before `of` is joined to it, the properties of appearance that `of` has, with defaults:
/// texture coordinates (0, 0), no material, no groups, white.
void take_looks(Mesh& mesh, const Mesh& of);

}  // namespace sherd
