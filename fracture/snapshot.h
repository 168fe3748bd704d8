// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shell/face_fields.h"
#include "core/state_visitor.h"
#include "fracture/edge_state.h"
#include "fracture/mesh_state.h"
#include "meshops/attributes.h"

namespace sherd {

/// The mesh of a snapshot at rest, with all copies of a vertex merged, and how it lies in the unfractured
/// mesh. A crack may split faces, which inserts vertices in edges and faces; the parts of a face lie in that
/// face, which is flat at rest. A crack may also move vertices and flip edges; then a face may cover parts of
/// several unfractured faces.
struct RestMesh {
    Positions position;  ///< [3, R] m; the first are the vertices of the unfractured mesh, with their moves
    std::vector<std::array<Index, 3>> faces;  ///< [F] corners, columns of position
    std::vector<double> area;                 ///< [F] m^2
    std::vector<double> thickness;            ///< [F] m; empty in recordings of versions without it

    std::vector<std::array<Index, 3>> vertex_parents;   ///< [R] vertices of the unfractured mesh
    std::vector<std::array<double, 3>> vertex_weights;  ///< [R] shares of vertex_parents, which sum to 1
    std::vector<Index> face_parent;  ///< [F] face of the unfractured mesh that covers it, or most of it
    /// [F] 1 for faces that cover parts of several: not all corners lie in the parent; empty: there is none.
    std::vector<std::uint8_t> face_mixed = {};
    SurfaceLook look = {};  ///< what is recorded of it, with vertices [R] and faces [F]
    std::vector<std::array<Index, 3>> unbroken_faces;  ///< [F0] faces of the unfractured mesh
    Positions unbroken_position = {};                  ///< [3, V0] m, vertices of the unfractured mesh

    void visit_state(StateVisitor& visit) {
        auto& [position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed,
               look, unbroken_faces, unbroken_position] = *this;
        visit(position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed,
              unbroken_faces, unbroken_position);
        visit_look(visit, look);
    }
};

/// The shell at one time, as plain arrays: a frame of a recording. From one snapshot of a run to the next
/// vertices, edges and faces are only appended. A face that is split keeps its number for one of its parts,
/// and an edge that is flipped keeps its number.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0;  ///< s

    Positions position;           ///< [3, V] m
    Positions velocity;           ///< [3, V] m/s
    VectorXd mass;                ///< [V] kg
    std::vector<Index> original;  ///< [V] the vertex at rest of each: a column of rest.position

    std::vector<std::array<Index, 3>> faces;  ///< [F]
    std::vector<Index> face_fragment;         ///< [F] number of each face's fragment
    std::vector<Index> face_sheet;            ///< [F] number of the sheet in the scene

    std::vector<std::array<Index, 2>> edges;  ///< [E] end points
    std::vector<EdgeState> edge_state;        ///< [E]
    std::vector<double> edge_strain;          ///< [E] 1/m, signed bending strain; zero without a hinge
    /// [E] remaining share of the cohesive force of each edge while it opens; empty: none opens gradually.
    std::vector<double> edge_held = {};

    RestMesh rest;      ///< mesh at rest, with the same faces
    FaceFields fields;  ///< fields that were asked for
};

/// Returns the rest mesh of a mesh that is its own unfractured mesh.
RestMesh unbroken_mesh(Positions position, std::vector<std::array<Index, 3>> faces, std::vector<double> area,
                       std::vector<double> thickness);

/// Barycentric coordinates of a face's corner (0, 1, 2) in its parent face; where the face is mixed and the
/// corner lies beside the parent, those of its projection into the parent's plane.
Vector3d place_in_parent(const RestMesh& rest, std::size_t face, int corner);

class BreakableShell;

/// Takes a snapshot of the current state; the caller sets step and time. face_fragment: [F].
Snapshot take_snapshot(const BreakableShell& shell, std::span<const Index> face_fragment);

}  // namespace sherd
