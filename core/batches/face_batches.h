// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/batches/corner_sums.h"
#include "core/shell/shell.h"

namespace sherd {

/// Derivatives of an energy by the dihedral angles at the sides of faces in batches.
struct SideMoments {
    std::vector<std::array<LaneIndices, 3>> sides;  ///< sides of each batch, as numbers in per_length
    std::vector<double> per_length;                 ///< N, derivatives over the sides' lengths

    LanesVector of(Index batch) const {
        const auto& [a, b, c] = sides[batch];
        return {gather(per_length, a), gather(per_length, b), gather(per_length, c)};
    }
};

/// The faces of a shell in batches, with the gradient of their membrane energy (constant strain).
class FaceBatches {
  public:
    /// Makes the batches, and appends the corners of all faces to `corners`.
    void build(const Shell& shell, CornerSums& corners);
    Index size() const { return static_cast<Index>(batches.size()); }

    /// Writes the gradients, N, of the batches from `begin` to before `end` to their corners, with those of
    /// bending, if it is given.
    void find(Index begin, Index end, const PaddedPositions& x, const SideMoments* bending,
              CornerSums& corners) const;

  private:
    struct alignas(sizeof(Lanes)) Batch {
        std::array<std::array<Lanes, 2>, 2>
            derivatives;  ///< 1/m, MembraneTriangle::derivatives of the second and the third corner
        std::array<Lanes, 6> stiffness;  ///< area times elasticity, J: 00, 11, 22, 01, 02, 12
        std::array<LaneIndices, 3> vertices;
        Index place;  ///< place of the first corner
    };
    std::vector<Batch> batches;
};

}  // namespace sherd
