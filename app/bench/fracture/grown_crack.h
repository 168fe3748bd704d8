// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/fracture/fracture_case.h"

namespace sherd {

/// The first of the cracks that the scene's first sheet has from the start.
struct FirstCrack {
    Vector2d from, to;  ///< m, ends

    explicit FirstCrack(const Scene& scene);
    double half_length() const { return 0.5 * (to - from).norm(); }
    double angle() const;  ///< rad, from the x axis
};

/// An edge along which a tip advanced, at rest.
struct GrownEdge {
    Vector2d from, to;  ///< m, ends, in the direction of the tip
    std::int64_t step;  ///< number of the step in which the edge failed
};

/// The edges that failed in the steps of a run, in this order. Each begins at the end that is nearer to a
/// tip, and moves the nearest tip to its other end; at first the tips are the ends of FirstCrack.
std::vector<GrownEdge> grown_edges(const FractureHistory& run);

/// The records of the tips in the last step.
std::vector<TipRecord> last_tips(const FractureHistory& run);

/// The lower and the upper corner of the box around the first sheet's outline, m.
std::array<Vector2d, 2> outline_corners(const Scene& scene);

}  // namespace sherd
