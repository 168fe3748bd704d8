// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/batches/corner_sums.h"
#include "core/batches/level_order.h"
#include "core/bending/coupled_bending.h"
#include "core/shell/shell.h"
#include "core/threads.h"

namespace sherd {

/// Derivatives of a bending energy by the angles of the folds at the sides of faces.
struct SideMoments {
    std::vector<std::array<Index, 3>> of_face;  ///< for each face and side, an index in per_length
    std::vector<Level> levels;                  ///< levels of the entries of per_length
    std::vector<double> per_length;             ///< N, derivatives by angles over the sides' lengths
};

/// The faces of a shell in batches, with the gradient of their membrane energy (constant strain).
class FaceBatches {
  public:
    /// Makes the batches, and appends the corners of the faces to `corners`. levels: of the vertices;
    /// bending: see find(). Raises the entries of `at_vertices` to the levels of the faces around them.
    void build(const Shell& shell, const std::vector<Level>& levels, const SideMoments* bending,
               CornerSums& corners, std::vector<Level>& at_vertices);
    /// Number of the first batches, which together contain all faces of at least this level.
    Index size(int level) const { return batches_of(order.count(level)); }

    /// Writes the gradients, N, of the batches from `begin` to before `end` to their places in `corners`.
    /// bending: derivatives of a bending energy, whose gradient is added; null: none.
    void find(Index begin, Index end, const PaddedPositions& x, const SideMoments* bending,
              CornerSums& corners) const;
    double energy(const PaddedPositions& x) const;  ///< J, of the membrane

  private:
    /// Deformation of four faces.
    struct Strained {
        LanesVector one, other;  ///< m, from the first corner to the second and to the third
        Eigen::Matrix<Lanes, 3, 2> F;
        LanesVector strain, stress;  ///< stress times area, J
    };
    struct alignas(sizeof(Lanes)) Batch {
        std::array<std::array<Lanes, 2>, 2>
            derivatives;  ///< 1/m, MembraneTriangle::derivatives of the second and the third corner
        std::array<Lanes, 6> stiffness;  ///< area times elasticity, J: 00, 11, 22, 01, 02, 12
        std::array<LaneIndices, 3> vertices;
        std::array<LaneIndices, 3> sides;  ///< indices in SideMoments::per_length
        Index place;                       ///< number in CornerSums of the first corner's place

        Strained at(const PaddedPositions& x) const;
    };
    LevelOrder order;
    std::vector<Batch> batches;
};

/// The derivative of the energy of coupled hinges by the angles of folds. A face's energy is quadratic in the
/// angles from its facet to the tangents at its sides, and these angles are weighted sums of the angles of
/// folds (FaceCurvature). The energy is that of CoupledBending, summed in another order.
class CoupledBatches {
  public:
    /// levels: of the vertices.
    void build(const Shell& shell, const CoupledBending& bending, const std::vector<Level>& levels);
    /// Computes the derivatives at the positions x, after vertices of at least `level` have moved since the
    /// last call. of_mirrors: changes of the mirrors' angles, rad; they are replaced by the energy's
    /// derivatives by them, N m.
    void find(const PaddedPositions& x, int level, const Threads& threads, std::vector<double>& of_mirrors);
    /// Derivatives of the energy by the angles of hinges at the sides of faces, as the last find() has
    /// computed them.
    const SideMoments& moments() const { return at_sides; }
    /// The energy, J, at the positions of a find() of all levels.
    double energy() const;
    /// Level of the derivative by a mirror's angle.
    Level level_of_mirror(Index mirror) const { return at_sides.levels[of_hinges + mirror]; }

  private:
    /// Four hinges.
    struct alignas(sizeof(Lanes)) Hinges {
        std::array<Lanes, 2> start;  ///< cos and sin of the angle from which changes are measured
        std::array<LaneIndices, 4> vertices;
        LaneIndices number;
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
    void build_shares(const CoupledBending& bending);
    void build_tangents(const CoupledBending& bending);
    void find_levels(const CoupledBending& bending, const std::vector<Level>& of_vertices);
    void build_hinges(const CoupledBending& bending);
    void build_faces(const CoupledBending& bending);
    /// Number here of a fold of CoupledBending: here hinges come first, then mirrors.
    Index number(const CoupledBending& bending, Index fold) const;

    void find_changes(Index begin, Index end, const PaddedPositions& x);
    void find_tangents(Index begin, Index end);
    void find_of_tangents(Index begin, Index end);
    void find_moments(Index begin, Index end);
    double moment(Index fold) const;

    Index of_hinges = 0, folds = 0;  ///< number of hinges, and of all folds
    const Shell* shell = nullptr;
    /// By the levels of the angles of hinges, of their tangents, of faces, and of the moments of hinges.
    LevelOrder hinge_order, tangent_order, face_order, moment_order;
    std::vector<Hinges> hinges;
    std::vector<Faces> faces;
    std::vector<std::array<Index, 3>> tangents_of_face;  ///< for each face and side, an index in `tangents`
    Rows shares;  ///< shares of folds (columns) in the angle from T0's facet to each hinge's tangent (rows)
    Rows shared;  ///< transpose of `shares`
    std::vector<double> changes, of_length;  ///< changes of the folds' angles, rad; one over the hinges'
                                             ///< lengths, 1/m
    /// tangents: for each fold the changes of the angles from the facets of T0 and T1 to the tangent, rad,
    /// then a zero for free sides. of_tangents: the energy's derivatives by the entries of `tangents`, N m.
    std::vector<double> tangents, of_tangents;
    SideMoments at_sides;
};

}  // namespace sherd
