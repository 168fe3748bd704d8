// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/batches/corner_sums.h"
#include "core/bending/cubic_hinge.h"
#include "core/shell/shell.h"

namespace sherd {

/// The cubic hinges of a shell in batches, with the gradient of their energy.
class HingeBatches {
  public:
    /// Makes the batches, and appends the vertices of all hinges to `corners`.
    void build(const Shell& shell, const std::vector<CubicHinge>& hinges, CornerSums& corners);
    Index size() const { return static_cast<Index>(batches.size()); }

    /// Writes the gradients, N, of the batches from `begin` to before `end` to their corners.
    void find(Index begin, Index end, const PaddedPositions& x, CornerSums& corners) const;

  private:
    struct alignas(sizeof(Lanes)) Batch {
        std::array<Lanes, 6> quadratic;  ///< N/m, of all vertices but the first: 00, 11, 22, 01, 02, 12
        Lanes cubic;                     ///< N/m^2
        std::array<LaneIndices, 4> vertices;
        Index place;  ///< place of the first vertex
    };
    std::vector<Batch> batches;
};

}  // namespace sherd
