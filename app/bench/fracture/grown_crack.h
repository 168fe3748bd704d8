// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/fracture/fracture_case.h"

namespace sherd {

/// The ends of the first crack that the scene's first sheet has from the start, m.
struct FirstCrack {
    Vector2d from, to;

    explicit FirstCrack(const Scene& scene);
    double half_length() const { return 0.5 * (to - from).norm(); }
    double angle() const;  ///< rad, from the x axis
};

/// An edge that a tip took, at rest.
struct GrownEdge {
    Vector2d from, to;  ///< m
    std::int64_t step;
};

/// The edges that have failed in the steps of a run, each seen from the tip that it is nearer to.
std::vector<GrownEdge> grown_edges(const FractureHistory& run);

/// Loads of the tips in the last step.
std::vector<TipRecord> last_tips(const FractureHistory& run);

/// The lower and the upper corner of the first sheet's outline, m.
std::array<Vector2d, 2> outline_corners(const Scene& scene);

}  // namespace sherd
