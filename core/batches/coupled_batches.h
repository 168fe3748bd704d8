// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/batches/face_batches.h"
#include "core/bending/coupled_bending.h"
#include "core/threads.h"

namespace sherd {

/// The derivative of the energy of coupled hinges by the angles of folds. A face's energy is quadratic in the
/// angles from its facet to the tangents at its sides, and those follow from the angles of folds by shares
/// (FaceCurvature): the sum is CoupledBending's in another order.
class CoupledBatches {
  public:
    void build(const Shell& shell, const CoupledBending& bending);
    /// of_mirrors: changes of their angles, rad; they become the energy's derivatives by them, N m.
    void find(const PaddedPositions& x, const Threads& threads, std::vector<double>& of_mirrors);
    /// Of the hinges at the sides of faces.
    const SideMoments& moments() const { return at_sides; }

  private:
    /// Four hinges.
    struct alignas(sizeof(Lanes)) Hinges {
        std::array<Lanes, 2> start;  ///< cos and sin of the angle from which changes are measured
        std::array<LaneIndices, 4> vertices;
    };
    /// Four faces.
    struct alignas(sizeof(Lanes)) Faces {
        /// Twice the energy is the square of the angles at the sides with it, N m: 00, 11, 22, 01, 02, 12.
        std::array<Lanes, 6> rigidity;
        std::array<LaneIndices, 3> tangents;  ///< numbers of these angles
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
    /// Among the folds here; that of a mirror comes after the hinges.
    Index number(const CoupledBending& bending, Index fold) const;

    void find_changes(Index begin, Index end, const PaddedPositions& x);
    void find_tangents(Index begin, Index end);
    void find_of_tangents(Index begin, Index end);
    void find_moments(Index begin, Index end);
    double moment(Index fold) const;

    Index of_hinges = 0, folds = 0;  ///< how many folds are hinges, in whole batches, and all
    const Shell* shell = nullptr;
    std::vector<Hinges> hinges;
    std::vector<Faces> faces;
    Rows shares;                             ///< of folds in the angles to T0's tangents
    Rows shared;                             ///< the same by fold
    std::vector<double> changes, of_length;  ///< rad and 1/m, of folds: since the start; one over the length
    /// rad, to the tangents of T0 and T1 of each fold, and of free sides, where they are zero; and the
    /// energy's derivatives by them, N m.
    std::vector<double> tangents, of_tangents;
    SideMoments at_sides;
};

}  // namespace sherd
