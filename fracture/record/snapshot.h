// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/shell/face_fields.h"
#include "core/state_visitor.h"
#include "fracture/mesh/crack_mesh.h"
#include "fracture/mesh/mesh_state.h"
#include "fracture/shell/rest_mesh.h"
#include "meshops/attributes.h"

namespace sherd {

/// The shell at one time, as plain arrays: a frame of a recording. From one snapshot of a run to the next
/// vertices, edges and faces are only appended. When a face is split, one of its parts keeps its number, and
/// an edge that is flipped keeps its number.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0;  ///< s

    Positions position;           ///< [3, V] m
    Positions velocity;           ///< [3, V] m/s
    VectorXd mass;                ///< [V] kg
    std::vector<Index> original;  ///< [V] column of rest.position that is the vertex at rest

    std::vector<std::array<Index, 3>> faces;  ///< [F] corners
    std::vector<Index> face_fragment;         ///< [F] number of each face's fragment
    std::vector<Index> face_sheet;            ///< [F] number of the sheet in the scene

    std::vector<std::array<Index, 2>> edges;  ///< [E] end points
    std::vector<EdgeState> edge_state;        ///< [E]
    std::vector<double> edge_strain;          ///< [E] 1/m, signed bending strain; zero without a hinge
    /// [E] share, 0 to 1, of the cohesive force that still acts on each edge while the edge opens; empty: no
    /// edge opens gradually.
    std::vector<double> edge_cohesive_share = {};

    RestMesh rest;      ///< mesh at rest, with the same faces
    FaceFields fields;  ///< fields of faces that the caller chose
};

/// Kinds of elements of a snapshot. An array has an entry for each element of one kind.
enum class Elements { vertices, faces, edges, rest_vertices };

/// Elements to which the numbers in an array refer; `nothing`: the numbers are no indices.
enum class Names {
    nothing,
    vertices,
    rest_vertices,
    fragments,
    sheets,
    unfractured_vertices,
    unfractured_faces
};

enum class Presence {
    always,
    may_be_empty,  ///< stored even if it is empty
    if_any         ///< not stored if it is empty
};

/// Row of the table of a snapshot's arrays.
struct SnapshotArray {
    const char* name;  ///< name of the dataset in the frames of a recording
    Elements entries;
    const char* unit = "1";
    const char* meaning = "";  ///< description in recordings
    Names names = Names::nothing;
    Presence presence = Presence::always;
    bool shown = false;  ///< whether the index file for ParaView lists the array
};

/// Calls visit(SnapshotArray, array) for each array of a snapshot, except the arrays of its mesh at rest and
/// of its fields.
template <class S, class Visit>
void visit_arrays(S& snapshot, const Visit& visit) {
    using A = SnapshotArray;
    visit(A{.name = "vertex/position", .entries = Elements::vertices, .unit = "m"}, snapshot.position);
    visit(A{.name = "vertex/velocity", .entries = Elements::vertices, .unit = "m/s", .shown = true},
          snapshot.velocity);
    visit(A{.name = "vertex/mass", .entries = Elements::vertices, .unit = "kg"}, snapshot.mass);
    visit(A{.name = "vertex/original",
            .entries = Elements::vertices,
            .meaning = "vertex that this one is a copy of, or its own number: a row of rest/position",
            .names = Names::rest_vertices},
          snapshot.original);
    visit(A{.name = "face/vertices",
            .entries = Elements::faces,
            .meaning = "the three corners, as rows of vertex/*",
            .names = Names::vertices},
          snapshot.faces);
    visit(A{.name = "face/fragment",
            .entries = Elements::faces,
            .meaning = "number of the fragment, kept while others split: see /events/fragment",
            .names = Names::fragments,
            .shown = true},
          snapshot.face_fragment);
    visit(A{.name = "face/sheet",
            .entries = Elements::faces,
            .meaning = "row of /rest/sheet_names",
            .names = Names::sheets,
            .shown = true},
          snapshot.face_sheet);
    visit(A{.name = "edge/vertices",
            .entries = Elements::edges,
            .meaning = "the two end points, as rows of vertex/*",
            .names = Names::vertices},
          snapshot.edges);
    visit(
        A{.name = "edge/state",
          .entries = Elements::edges,
          .meaning = "0 interior (carries a hinge), 1 fractured interior (failed, still closed), 2 boundary",
          .shown = true},
        snapshot.edge_state);
    visit(A{.name = "edge/strain",
            .entries = Elements::edges,
            .unit = "1/m",
            .meaning = "hinge strain, signed; 0 where there is no hinge",
            .shown = true},
          snapshot.edge_strain);
    visit(A{.name = "edge/held",
            .entries = Elements::edges,
            .meaning =
                "cohesive share: part of the force across an opening edge that remains; 0: none, or unbroken",
            .presence = Presence::if_any},
          snapshot.edge_cohesive_share);
}

/// Calls visit(SnapshotArray, array) for each array of a mesh at rest, except the arrays of its look.
template <class R, class Visit>
void visit_rest_arrays(R& rest, const Visit& visit) {
    using A = SnapshotArray;
    visit(A{.name = "rest/position", .entries = Elements::rest_vertices, .unit = "m"}, rest.position);
    visit(A{.name = "rest/faces",
            .entries = Elements::faces,
            .meaning = "the three corners, as rows of position",
            .names = Names::rest_vertices},
          rest.faces);
    visit(A{.name = "rest/area", .entries = Elements::faces, .unit = "m^2", .meaning = "of each face"},
          rest.area);
    visit(A{.name = "rest/thickness",
            .entries = Elements::faces,
            .unit = "m",
            .meaning = "of each face",
            .presence = Presence::may_be_empty},
          rest.thickness);
    visit(A{.name = "rest/vertex_parents",
            .entries = Elements::rest_vertices,
            .meaning = "vertices of the unbroken mesh (/rest) between which the vertex lies",
            .names = Names::unfractured_vertices},
          rest.vertex_parents);
    visit(A{.name = "rest/vertex_weights",
            .entries = Elements::rest_vertices,
            .meaning = "shares of vertex_parents, which sum to 1"},
          rest.vertex_weights);
    visit(A{.name = "rest/face_parent",
            .entries = Elements::faces,
            .meaning = "face of the unbroken mesh (/rest) of which the face is a part",
            .names = Names::unfractured_faces},
          rest.face_parent);
    visit(A{.name = "rest/face_mixed",
            .entries = Elements::faces,
            .meaning = "1: a mixed face, which covers parts of several faces of /rest",
            .presence = Presence::if_any},
          rest.face_mixed);
}

class BreakableShell;

/// Takes a snapshot of the current state; the caller sets step and time. face_fragment: [F] number of each
/// face's fragment.
Snapshot take_snapshot(const BreakableShell& shell, std::span<const Index> face_fragment);

}  // namespace sherd
