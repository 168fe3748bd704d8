// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shell/face_fields.h"
#include "core/state_visitor.h"
#include "fracture/edge_state.h"
#include "fracture/surface_look.h"

namespace sherd {

/// The mesh of a snapshot at rest, with copies of a vertex as the one that they are copies of, and how it
/// lies in the unbroken mesh: a crack may split faces, so that vertices are born inside edges and faces, and
/// parts of a face become faces. Part of a face lies in that face, which is flat at rest. A crack may also
/// move vertices and flip edges; then faces have parts of several.
struct RestMesh {
    Positions position;                       ///< [3, R] m; the first are the vertices of the unbroken mesh,
                                              ///< where they are now
    std::vector<std::array<Index, 3>> faces;  ///< [F] corners, columns of position
    std::vector<double> area;                 ///< [F] m^2
    std::vector<double> thickness;            ///< [F] m; empty in recordings of before there was any

    std::vector<std::array<Index, 3>> vertex_parents;   ///< [R] vertices of the unbroken mesh, and
    std::vector<std::array<double, 3>> vertex_weights;  ///< [R] their shares, which sum to 1
    std::vector<Index> face_parent;  ///< [F] face of the unbroken mesh that it is part of, or has most of
    /// [F] 1 of faces that have parts of several: not all corners lie in the parent; empty: there is none.
    std::vector<std::uint8_t> face_mixed = {};
    SurfaceLook look = {};
    std::vector<std::array<Index, 3>> unbroken_faces;  ///< [F0] of the unbroken mesh
    Positions unbroken_position = {};                  ///< [3, V0] m

    void visit_state(StateVisitor& visit) {
        auto& [position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed,
               look, unbroken_faces, unbroken_position] = *this;
        visit(position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed, look,
              unbroken_faces, unbroken_position);
    }
};

/// The shell at one moment, as plain arrays: what a recording stores of a frame. From one snapshot of a run
/// to the next vertices, edges and faces are only appended. A face that is split keeps its number for one of
/// its parts, and an edge that is flipped keeps its number.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0;  ///< s

    Positions position;           ///< [3, V] m
    Positions velocity;           ///< [3, V] m/s
    VectorXd mass;                ///< [V] kg
    std::vector<Index> original;  ///< [V] vertex at rest that this one is, or is a copy of: a column of
                                  ///< rest.position

    std::vector<std::array<Index, 3>> faces;  ///< [F]
    std::vector<Index> face_fragment;         ///< [F] number of each face's fragment
    std::vector<Index> face_sheet;            ///< [F] number of the sheet in the scene

    std::vector<std::array<Index, 2>> edges;  ///< [E] end points
    std::vector<EdgeState> edge_state;        ///< [E]
    std::vector<double> edge_strain;          ///< [E] 1/m, signed bending strain; zero without a hinge
    /// [E] share of what held each edge together that still does while it opens; empty: none opens gradually.
    std::vector<double> edge_held = {};

    RestMesh rest;      ///< of the same faces
    FaceFields fields;  ///< of faces, as far as they were wanted
};

/// A mesh of which nothing has been split.
RestMesh unbroken_mesh(Positions position, std::vector<std::array<Index, 3>> faces, std::vector<double> area,
                       std::vector<double> thickness);

/// Barycentric coordinates of a face's corner (0, 1, 2) in the face that it is a part of; in its plane, where
/// the face is mixed and the corner lies beside it.
Vector3d place_in_parent(const RestMesh& rest, std::size_t face, int corner);

class BreakableShell;

/// Takes a snapshot of the current state; the caller sets step and time. face_fragment: [F].
Snapshot take_snapshot(const BreakableShell& shell, std::span<const Index> face_fragment);

}  // namespace sherd
