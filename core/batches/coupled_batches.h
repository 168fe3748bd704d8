// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/batches/corner_sums.h"
#include "core/bending/coupled_bending.h"
#include "core/shell/shell.h"
#include "core/threads.h"

namespace sherd {

/// Derivatives of an energy by the dihedral angles at the sides of faces in batches.
struct SideMoments {
    std::vector<std::array<LaneIndices, 3>> sides;  ///< for each batch and side, indices in per_length
    std::vector<double> per_length;                 ///< N, derivatives by angles over the sides' lengths

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

    /// Writes the gradients, N, of the batches from `begin` to before `end` to their places in `corners`.
    /// bending: derivatives of a bending energy, whose gradient is added; null: none.
    void find(Index begin, Index end, const PaddedPositions& x, const SideMoments* bending,
              CornerSums& corners) const;

  private:
    struct alignas(sizeof(Lanes)) Batch {
        std::array<std::array<Lanes, 2>, 2>
            derivatives;  ///< 1/m, MembraneTriangle::derivatives of the second and the third corner
        std::array<Lanes, 6> stiffness;  ///< area times elasticity, J: 00, 11, 22, 01, 02, 12
        std::array<LaneIndices, 3> vertices;
        Index place;  ///< number in CornerSums of the first corner's place
    };
    std::vector<Batch> batches;
};

/// The derivative of the energy of coupled hinges by the angles of folds. A face's energy is quadratic in the
/// angles from its facet to the tangents at its sides, and these angles are weighted sums of the angles of
/// folds (FaceCurvature). The energy is that of CoupledBending, summed in another order.
class CoupledBatches {
  public:
    void build(const Shell& shell, const CoupledBending& bending);
    /// Computes the derivatives at the positions x. of_mirrors: changes of the mirrors' angles, rad; they are
    /// replaced by the energy's derivatives by them, N m.
    void find(const PaddedPositions& x, const Threads& threads, std::vector<double>& of_mirrors);
    /// Derivatives of the energy by the angles of hinges at the sides of faces, as the last find() has
    /// computed them.
    const SideMoments& moments() const { return at_sides; }

  private:
    /// Four hinges.
    struct alignas(sizeof(Lanes)) Hinges {
        std::array<Lanes, 2> start;  ///< cos and sin of the angle from which changes are measured
        std::array<LaneIndices, 4> vertices;
    };
    /// Four faces.
    struct alignas(sizeof(Lanes)) Faces {
        /// Matrix of the quadratic form in the angles to the tangents at the three sides whose value is twice
        /// the energy, N m: entries 00, 11, 22, 01, 02, 12.
        std::array<Lanes, 6> rigidity;
        std::array<LaneIndices, 3> tangents;  ///< indices of these angles in CoupledBatches::tangents
    };
    /// The rows of a sparse matrix.
    struct Rows {
        std::vector<Index> start{0}, column;
        std::vector<double> weight;

        void append(Index to, double times) {
            column.push_back(to);
            weight.push_back(times);
        }
        void end_row() { start.push_back(static_cast<Index>(column.size())); }
        Rows transposed(Index columns) const;
    };

    void build_hinges(const CoupledBending& bending);
    void build_faces(const CoupledBending& bending);
    /// Number here of a fold of CoupledBending: here hinges come first, then mirrors.
    Index number(const CoupledBending& bending, Index fold) const;

    void find_changes(Index begin, Index end, const PaddedPositions& x);
    void find_tangents(Index begin, Index end);
    void find_of_tangents(Index begin, Index end);
    void find_moments(Index begin, Index end);
    double moment(Index fold) const;

    Index of_hinges = 0, folds = 0;  ///< number of hinges, filled up to whole batches; number of all folds
    const Shell* shell = nullptr;
    std::vector<Hinges> hinges;
    std::vector<Faces> faces;
    Rows shares;  ///< shares of folds (columns) in the angle from T0's facet to each hinge's tangent (rows)
    Rows shared;  ///< transpose of `shares`
    std::vector<double> changes, of_length;  ///< changes of the folds' angles, rad; one over the hinges'
                                             ///< lengths, 1/m
    /// tangents: for each fold the changes of the angles from the facets of T0 and T1 to the tangent, rad,
    /// then zeros for free sides. of_tangents: the energy's derivatives by the entries of `tangents`, N m.
    std::vector<double> tangents, of_tangents;
    SideMoments at_sides;
};

}  // namespace sherd
