// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "meshops/topology/advance/advance_edge.h"
#include "meshops/topology/advance/patch_trial.h"

namespace sherd {

/// A trial that makes the requested vertex.
struct Candidate {
    std::unique_ptr<PatchTrial> trial;
    Vertex vertex;  ///< vertex of the trial
    AdvancedEdge::Way way;
    double distance = 0;  ///< distance of the vertex along the ray, m
    double angle = -1;    ///< smallest angle of the changed faces, rad; -1 if one has turned over
};

/// Candidate without any flips or moves of other vertices.
Candidate plain_candidate(std::unique_ptr<PatchTrial> trial, Vertex vertex, AdvancedEdge::Way way,
                          double distance);

/// Returns the first candidate, in the order of AdvancedEdge::Way, that keeps the angles of `options`. snaps:
/// the best candidate of each vertex, preferred vertices first; cuts: in any order. Returns a candidate
/// without a trial if none is acceptable.
Candidate chosen(std::vector<Candidate> snaps, std::vector<Candidate> cuts, const AdvanceOptions& options);

}  // namespace sherd
