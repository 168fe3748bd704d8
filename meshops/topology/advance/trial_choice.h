// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "meshops/topology/advance/advance_edge.h"
#include "meshops/topology/advance/patch_trial.h"

namespace sherd {

/// A trial in which a vertex is made at a requested place, by moving or inserting it.
struct Candidate {
    std::unique_ptr<PatchTrial> trial;
    Vertex vertex;  ///< the vertex, in the mesh of the trial
    AdvancedEdge::Way way;
    double distance = 0;  ///< distance of the vertex along the ray, m
    double angle = -1;    ///< smallest angle of the changed faces, rad; -1 if one has turned over
};

/// Returns the candidate of a trial as it is, without any flips or moves of other vertices.
Candidate plain_candidate(std::unique_ptr<PatchTrial> trial, Vertex vertex, AdvancedEdge::Way way,
                          double distance);

/// Chooses a candidate: the first of `snaps` that keeps options.snap_angle. If there is none, other vertices
/// are flipped and moved; then the best of `snaps` if it keeps options.wanted_angle, or else the best of all
/// if it does. If none does, the best of all that keep options.smallest_angle or leave no smaller angle than
/// the faces that they replace; or, with options.always_straight, in which no face turns over. Returns a
/// candidate without a trial if there is none. snaps: the best candidate of each vertex that may be moved,
/// preferred vertices first; cuts: candidates with an inserted vertex, in any order.
Candidate chosen(std::vector<Candidate> snaps, std::vector<Candidate> cuts, const AdvanceOptions& options);

}  // namespace sherd
