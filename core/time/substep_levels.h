// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batches/level_order.h"
#include "core/shell/shell.h"

namespace sherd {

/// Division of an explicit step into substeps with local time steps.
struct SubstepLevels {
    int substeps = 1;
    std::vector<Level> levels;  ///< [V] see LocalSteps; empty: all are 0
};

/// Levels of the vertices in a substep (s); nothing if a vertex would need a higher level than there is.
/// stable: [V] s, longest stable step of each vertex; share: part of it that short steps may have at vertices
/// with levels above 0.
std::vector<Level> levels_in(const Shell& shell, const VectorXd& stable, double substep, double share);

/// Limits on levels.
struct LevelLimits {
    bool allowed = true;  ///< whether levels may differ from 0
    double share = 1;     ///< share of the stable step for vertices with levels above 0
    double shortest = 0;  ///< s, length of the shortest substep with levels above 0
};

/// Chooses the number of substeps, and the levels of vertices, with the least work. stable: [V] s, longest
/// stable step of each vertex; step: s.
SubstepLevels substep_levels(const Shell& shell, const VectorXd& stable, double step,
                             const LevelLimits& limits);

}  // namespace sherd
