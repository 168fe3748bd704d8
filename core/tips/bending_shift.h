// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/tips/shell_part.h"
#include "core/tips/tip_shift.h"

namespace sherd {

/// How the energy of coupled hinges, 1/2 dtheta^T S dtheta, depends on the rest positions of a crack's tip
/// and its rings: through S, and through the angles at rest and now, since the vertices take their
/// displacements along. S's derivative is computed once, by central differences over the faces that see one
/// of the vertices, and the angles' in closed form; the sums are then quadratic in the changes of angles.
class BendingShift {
  public:
    /// Shell and bending must outlive this object, which must be made anew when they change near the tip.
    BendingShift(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                 TipShift shift);

    /// Minus the derivative of the energy, N, along the tip's direction and to its left. x: [3, V] m; turn:
    /// from rest to x at the tip.
    Vector2d force(const Positions& x, const Matrix3d& turn) const;

    std::size_t faces() const { return seen.size(); }  ///< number of those that see a vertex of these

  private:
    /// A face that sees a vertex that moves.
    struct Seen {
        Index face;
        std::vector<Index> folds;  ///< on which its curvature depends
        /// Derivative of its share of S by the two directions, N, [folds, folds].
        std::array<Eigen::MatrixXd, 2> stiffening;
    };
    bool moves(Index fold) const;  ///< whether one of its vertices does
    void see(Index face);          ///< if one of its folds moves
    /// Each seen face's share of S once the tip has advanced by `length` m along an axis; nothing where it
    /// then depends on other folds.
    std::vector<std::optional<Eigen::MatrixXd>> advanced_stiffness(ShellPart part, int axis,
                                                                   double length) const;
    void differentiate(int axis);
    /// The derivatives of angles times moments: of those now less those at rest.
    Vector2d turned_folds(const Positions& x, const Matrix3d& turn, const VectorXd& moments) const;

    const Shell& shell;
    const CoupledBending& bending;
    TipShift shift;
    std::vector<Seen> seen;
    std::vector<Index> folds;  ///< of all faces that are seen
    std::vector<Index> moved;  ///< of these, those with a vertex that moves
};

}  // namespace sherd
