// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/bending/patches.h"
#include "core/state_visitor.h"

namespace sherd {

/// The change of curvature of each face as a linear function of the changes of the dihedral angles around it.
/// The coefficients depend on the rest shape and on which hinges are left, and on nothing else.
///
/// A hinge's angle is the sum of two: from the facet of T0 to the sheet's tangent at the middle of the edge,
/// and from there to the facet of T1. How it is shared between them follows from the hinges around: their
/// angles are weighted so that every quadratic surface is shared exactly (tangent_angle()). A face's
/// curvature follows from the angles at its three sides (curvature_of_tangent()). At a mirror image (clamp or
/// symmetry plane) the two halves are equal. At a free side, also of a crack, the angle is the one that costs
/// the face the least energy, so that it carries no moment.
class FaceCurvature {
  public:
    /// The share of a fold in a face's curvature.
    struct Term {
        Index fold;
        Vector3d per_angle;  ///< (00, 11, 2 * 01) in the face's rest frame, 1/(m rad)
    };

    /// Shell and folds must outlive this object.
    FaceCurvature(const Shell& shell, const Folds& folds);

    /// Must be called when the shell has changed. Only the faces that depend on a part of the change are
    /// computed again; returns them by ascending number.
    std::vector<Index> follow(const ShellChange& change);

    /// Terms of the change of curvature of a face.
    std::span<const Term> terms(std::size_t face) const { return faces[face]; }
    /// The change of curvature of a face, (00, 11, 2 * 01), 1/m. changes: of all folds' angles, rad.
    Vector3d of(std::size_t face, const VectorXd& changes) const {
        Vector3d sum = Vector3d::Zero();
        for (const Term& term : faces[face]) sum += changes[term.fold] * term.per_angle;
        return sum;
    }

    /// The folds on which the curvatures of some faces depend, ascending.
    std::vector<Index> folds_of(std::span<const Index> some) const;
    /// The curvature of a face, (00, 11, 2 * 01) in a column, for each radian from its facet to the tangent
    /// at a side, 1/m, with the bending of its free sides that follows; columns of free sides are zero.
    Matrix3d per_tangent(Index face) const;
    /// Weights of folds in the angle from T0's facet to the tangent at an edge with a hinge.
    std::span<const Patches::Share> shares_of_first(Index edge) const { return shares[edge]; }
    /// Whether the side at an edge with a hinge is T0's.
    bool is_first(Index edge, const TriangleEdge& side) const {
        const TriangleEdge first = (*patches.sides_of(edge))[0];
        return first.triangle == side.triangle && first.corner == side.corner;
    }

    /// The faces' sides and their folds.
    const Patches& around() const { return patches; }

    void visit_state(StateVisitor& visit) {
        auto& [shell, folds, patches, shares, faces] = *this;
        visit(patches, shares, faces);
    }

  private:
    void renumber(const Patches::Change& change);
    Index folds_of_edges() const { return folds.folds_of_edges(); }
    std::vector<Patches::Share> shares_of(Index edge) const;
    void update_face(Index face);

    const Shell& shell;
    const Folds& folds;
    Patches patches;
    /// [E] weights of the folds around in the angle between T0's facet and the tangent at the edge; empty
    /// without a hinge.
    std::vector<std::vector<Patches::Share>> shares;
    std::vector<std::vector<Term>> faces;  ///< [F]
};

}  // namespace sherd
