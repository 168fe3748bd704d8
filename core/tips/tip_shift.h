// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tips/crack_tip.h"

namespace sherd {

/// Virtual advance of a crack in the rest shape: the tip and its first rings move, each vertex in its own
/// tangent plane, the same way. The field of advance is 1 there, 0 outside, and linear in the faces between.
struct TipShift {
    Index tip;
    std::vector<Index> vertices;  ///< by ascending number
    /// [vertices] displacement for each metre of advance: a column for the tip's direction, and one to its
    /// left.
    std::vector<Eigen::Matrix<double, 3, 2>> by;

    /// The number of a vertex in the list, -1 if it stays.
    Index find(Index vertex) const;
};

/// Virtual advance of the tip with its first `rings` rings, at most those that it has. The tip's axes are
/// turned into the tangent plane of each vertex by the smallest rotation.
TipShift tip_shift(const Shell& shell, const VertexFaces& around, const CrackTip& tip, int rings);

}  // namespace sherd
