// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/fracture/fracture_case.h"

namespace sherd {

struct FractureRun {
    std::size_t faces = 0;       ///< number of faces before the crack grew
    double seconds = 0;          ///< s, processor time
    std::vector<double> values;  ///< result of FractureCase::measure; empty: no crack grew, or no result
    std::vector<Vector2d> path;  ///< m, the crack's tip at the start, then the far ends of the failed edges
    std::string failure;         ///< why the run ended early, or that no crack grew; empty: neither
};

/// Simulates a case on a mesh with edges of the length `edge` (m). seed: of the scene; another seed makes
/// another mesh.
FractureRun run_fracture(const FractureCase& one, double edge, int seed);

/// Returns the largest distance, m, of a point of any of the paths from any other path.
double largest_distance(const std::vector<std::vector<Vector2d>>& paths);

}  // namespace sherd
