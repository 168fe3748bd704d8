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

/// The derivative of the energy of coupled hinges by the angles of folds. A face's energy is quadratic in the
/// angles from its facet to the tangents at its sides, and those follow from the angles of folds by shares
/// (FaceCurvature). The energy is that of CoupledBending, summed in another order.
class CoupledBatches {
  public:
    void build(const Shell& shell, const CoupledBending& bending);
    /// mirror_part: changes of the mirrors' angles, rad; replaced by the energy's derivatives by these, N m.
    void find(const PaddedPositions& x, const Threads& threads, std::vector<double>& of_mirrors);
    /// Derivatives of the energy by the angles of hinges at the sides of faces, from the last find().
    const SideMoments& moments() const { return at_sides; }

  private:
    /// Four hinges.
    struct alignas(sizeof(Lanes)) Hinges {
        std::array<Lanes, 2> start;  ///< cos and sin of the angle from which changes are measured
        std::array<LaneIndices, 4> vertices;
    };
    /// Four faces.
    struct alignas(sizeof(Lanes)) Faces {
        /// Quadratic form, N m, of the angles at the sides, whose value is twice the energy: 00, 11, 22, 01,
        /// 02, 12.
        std::array<Lanes, 6> rigidity;
        std::array<LaneIndices, 3> tangents;  ///< numbers of these angles in `tangents`
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
    /// Number of a fold among the folds here: hinges come first, then mirrors.
    Index number(const CoupledBending& bending, Index fold) const;

    void find_changes(Index begin, Index end, const PaddedPositions& x);
    void find_tangents(Index begin, Index end);
    void find_of_tangents(Index begin, Index end);
    void find_moments(Index begin, Index end);
    double moment(Index fold) const;

    Index of_hinges = 0, folds = 0;  ///< numbers of hinges, filled up to whole batches, and of all folds
    const Shell* shell = nullptr;
    std::vector<Hinges> hinges;
    std::vector<Faces> faces;
    Rows shares;  ///< shares of folds (columns) in the angles to T0's tangents (rows)
    Rows shared;  ///< transpose of `shares`
    std::vector<double> changes, of_length;  ///< rad, folds' changes; 1/m, one over hinges' lengths
    /// For each fold the changes of the angles from the facets of T0 and of T1 to the tangent, then zeros for
    /// free sides, rad; and the energy's derivatives by them, N m.
    std::vector<double> tangents, of_tangents;
    SideMoments at_sides;
};

}  // namespace sherd
