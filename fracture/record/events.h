// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// An edge whose hinge failed. Edge and vertex numbers refer to the mesh at that moment and stay valid.
struct EdgeFailure {
    double time = 0;  ///< s, end of the step in which it failed
    std::int64_t step = 0;
    Index stage = 0;  ///< stage of the step's staged breaking, from 0
    Index edge = 0;
    std::array<Index, 2> vertices{};  ///< end points
    Index boundary_vertices = 0;      ///< 0, 1 or 2 for the paper's B0, B1 or B2 when it failed
    double strain = 0;                ///< 1/m, surface strain over half the thickness
    double stress = 0;                ///< Pa, surface stress
    double overload = 0;              ///< measure over strength; above 1 if the edge failed by strength
};

/// A failed edge that opened: `edge` stays with one face, `created` is the new edge of the other face.
struct EdgeOpening {
    double time = 0;
    std::int64_t step = 0;
    Index edge = 0;
    Index created = 0;
};

/// A vertex that was split: `created` is a copy of `vertex`.
struct VertexSplit {
    double time = 0;
    std::int64_t step = 0;
    Index vertex = 0;
    Index created = 0;
};

/// A new fragment. Fragments that exist from the beginning have no event.
struct FragmentSplit {
    double time = 0;
    std::int64_t step = 0;
    Index fragment = 0;
    Index parent = 0;  ///< the fragment that it separated from, which keeps its number
};

/// A vertex that was inserted in an edge or a face.
struct VertexInsertion {
    double time = 0;
    std::int64_t step = 0;
    Index created = 0;
    std::array<Index, 3> parents{};   ///< vertices between which it was inserted
    std::array<double, 3> weights{};  ///< the parents' shares in its place at rest, which sum to 1; on an
                                      ///< edge the last is 0
};

/// A face that was inserted when faces were split: `parent` is the split face that covered most of it.
struct FaceInsertion {
    double time = 0;
    std::int64_t step = 0;
    Index created = 0;
    Index parent = 0;
};

/// A crack tip in a sheet that has a toughness, at the end of a step. Its load is that of its last
/// evaluation.
struct TipRecord {
    double time = 0;
    std::int64_t step = 0;
    Index tip = 0;  ///< number of the tip, which never changes
    Index vertex = 0;
    Vector3d position = Vector3d::Zero();   ///< m
    Vector3d direction = Vector3d::Zero();  ///< unit vector along its path at the tip, in the deformed sheet
    double speed = 0;                       ///< m/s; 0 in statics
    double released = 0;                    ///< G, J/m^2
    double toughness = 0;                   ///< G_c, J/m^2
    bool by_energy = false;         ///< whether G is a configurational force; else it follows from stress
    double opening = 0, shear = 0;  ///< K_I and K_II of the membrane, Pa m^0.5
    double bending = 0, twist = 0;  ///< k_1 and k_2 of bending, Pa m^0.5
};

/// The events of fracture, in chronological order.
struct CrackEvents {
    std::vector<EdgeFailure> failures;
    std::vector<EdgeOpening> openings;
    std::vector<VertexSplit> splits;
    std::vector<FragmentSplit> fragment_splits;
    std::vector<VertexInsertion> vertex_insertions;
    std::vector<FaceInsertion> face_insertions;
    std::vector<TipRecord> tips;

    void visit_state(StateVisitor& visit) {
        auto& [failures, openings, splits, fragment_splits, vertex_insertions, face_insertions, tips] = *this;
        visit(failures, openings, splits, fragment_splits, vertex_insertions, face_insertions, tips);
    }
};

/// Calls visit(kind) for every kind of event; kind: pointer to the member of CrackEvents with its events.
template <class Visit>
void visit_kinds(Visit visit) {
    visit(&CrackEvents::failures);
    visit(&CrackEvents::openings);
    visit(&CrackEvents::splits);
    visit(&CrackEvents::fragment_splits);
    visit(&CrackEvents::vertex_insertions);
    visit(&CrackEvents::face_insertions);
    visit(&CrackEvents::tips);
}

/// Sets the time (s) of the events of step `step`, which must be the last step with events.
void set_time(CrackEvents& events, std::int64_t step, double time);

/// Appends events for the new elements of a change of the mesh in step `step`: copies of vertices, inserted
/// vertices and inserted faces.
void append_insertions(const TopologyChange& change, std::int64_t step, CrackEvents& events);

/// Appends later events.
void append(CrackEvents& events, const CrackEvents& later);

}  // namespace sherd
