// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/fracture/fracture_case.h"

namespace sherd {

struct FractureRun {
    std::size_t faces = 0;       ///< faces of the mesh before anything grew
    double seconds = 0;          ///< processor time
    std::vector<double> values;  ///< the case's numbers; none: nothing grew, or it failed before
    std::vector<Vector2d> path;  ///< m, ends of the edges by which the crack grew, from its tip on
    std::string failure;         ///< why it was not computed to its end; empty: it was
};

/// Computes a case on a mesh with this length of edges, m.
FractureRun run_fracture(const FractureCase& one, double edge, int seed);

/// The largest distance, m, of a point of one path from another path, for any two of them.
double largest_distance(const std::vector<std::vector<Vector2d>>& paths);

}  // namespace sherd
