// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/bending/coupled_bending.h"
#include "core/tips/crack_tip.h"

namespace sherd {

/// Some faces of a shell as a shell of their own, with the data that coupled hinges need: corners,
/// elasticity, and folds that join two of the faces.
struct ShellPart {
    Shell shell;
    std::vector<MirrorHinge> mirrors;
    std::vector<Index> vertices;  ///< [V] numbers in the whole shell, ascending
    std::vector<Index> faces;     ///< [F] numbers in the whole shell, ascending
    std::vector<Index> folds;     ///< [mirrors + E] numbers in the whole shell, mirrors first
};

/// The part that has these folds, and all faces that they join.
ShellPart shell_part(const Shell& shell, const CoupledBending& bending, std::span<const Index> folds);

/// Sets the rest positions of the part, [3, V] m: areas and frames follow, and each face's elasticity keeps
/// its direction in the sheet.
void move_rest(ShellPart& part, const Positions& rest);

/// Virtual advance of a crack in the rest shape: the tip and its first rings move by the same distance, each
/// vertex in its own tangent plane. The field of advance is 1 at these vertices, 0 at all others, and linear
/// in the faces between.
struct TipShift {
    Index tip;
    std::vector<Index> vertices;  ///< by ascending number
    /// [vertices] displacement for each metre of advance: a column for an advance in the tip's direction,
    /// then a column for an advance to its left.
    std::vector<Eigen::Matrix<double, 3, 2>> by;

    /// Index of a vertex in `vertices`; -1 if the vertex stays.
    Index find(Index vertex) const;
};

/// Virtual advance of the tip with its first `rings` rings, or with all of its rings if it has fewer. The
/// tip's axes are turned into the tangent plane of each vertex by the smallest rotation.
TipShift tip_shift(const Shell& shell, const VertexFaces& around, const CrackTip& tip, int rings);

/// Dependence of the energy of coupled hinges, 1/2 dtheta^T S dtheta, on the rest positions of a crack's tip
/// and its rings. The energy depends on them through S, and through the angles at rest and now, since the
/// displacements of the vertices are kept when their rest positions move. The derivative of S is computed
/// once, by central differences over the faces whose curvature depends on these vertices; the derivatives of
/// the angles are computed in closed form. Given these, the force is a sum that is quadratic in the changes
/// of angles.
class BendingShift {
  public:
    /// Shell and bending must outlive this object, which must be replaced when they change near the tip.
    BendingShift(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                 TipShift shift);

    /// Configurational force: minus the derivative of the energy, N, along the tip's direction and to its
    /// left. x: [3, V] m; turn: rotation from rest to x at the tip.
    Vector2d force(const Positions& x, const Matrix3d& turn) const;

    std::size_t faces() const { return affected.size(); }  ///< number of faces that depend on moved vertices

  private:
    /// A face whose curvature depends on a moved vertex.
    struct AffectedFace {
        Index face;
        std::vector<Index> folds;  ///< folds on which its curvature depends
        /// Derivatives, N, of its contribution to S, [folds, folds], by an advance in each of the two
        /// directions.
        std::array<Eigen::MatrixXd, 2> stiffening;
    };
    bool moves(Index fold) const;      ///< whether a vertex of the fold moves
    void add_if_affected(Index face);  ///< adds the face if one of its folds moves
    /// Contribution of each affected face to S once the tip has advanced by `length` m along an axis; nothing
    /// for a face that then depends on other folds.
    std::vector<std::optional<Eigen::MatrixXd>> advanced_stiffness(ShellPart part, int axis,
                                                                   double length) const;
    void differentiate(int axis);
    /// Sum, N, over the moved folds, of a fold's moment times the derivative, by the advance, of its present
    /// angle less that of its rest angle.
    Vector2d turned_folds(const Positions& x, const Matrix3d& turn, const VectorXd& moments) const;

    const Shell& shell;
    const CoupledBending& bending;
    TipShift shift;
    std::vector<AffectedFace> affected;
    std::vector<Index> folds;  ///< folds of all affected faces
    std::vector<Index> moved;  ///< folds with a vertex that moves
};

}  // namespace sherd
