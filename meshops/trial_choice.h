// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "meshops/advance_edge.h"
#include "meshops/patch_trial.h"

namespace sherd {

/// A trial that gives a wanted vertex.
struct Candidate {
    std::unique_ptr<PatchTrial> trial;
    Vertex vertex;  ///< of the trial
    AdvancedEdge::Way way;
    double distance = 0;  ///< of the vertex along the ray, m
    double angle = -1;    ///< the smallest of its changed faces, rad; -1 if one has turned over
};

/// The vertex's faces as they come with nothing else changed.
Candidate plain_candidate(std::unique_ptr<PatchTrial> trial, Vertex vertex, AdvancedEdge::Way way,
                          double distance);

/// Chooses by the angles that `options` asks for, in the order of AdvancedEdge::Way. snaps: the best one of
/// each vertex, the preferred first; cuts: any. A candidate without a trial if none will do.
Candidate chosen(std::vector<Candidate> snaps, std::vector<Candidate> cuts, const AdvanceOptions& options);

}  // namespace sherd
