// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/bending/patches.h"
#include "core/state_visitor.h"

namespace sherd {

/// The change of curvature of each face as a linear function of the changes of the dihedral angles around it.
/// The coefficients depend only on the rest shape and on which hinges have not failed.
///
/// A hinge's angle is the sum of two angles: from the facet of T0 to the sheet's tangent at the middle of the
/// edge, and from the tangent to the facet of T1. Both are computed from the angles of the hinges around,
/// with weights that make them exact for every quadratic surface (tangent_angle()). A face's curvature
/// follows from the angles between its facet and the tangents at its three sides (curvature_of_tangent()).
/// Between a face and its mirror image (clamp or symmetry plane) the two angles are equal. At a free side,
/// which may be on a crack, the angle is such that the face's energy is least, so that the side carries no
/// moment.
class FaceCurvature {
  public:
    /// The share of a fold in a face's curvature.
    struct Term {
        Index fold;
        Vector3d per_angle;  ///< curvature (00, 11, 2 * 01) in the face's rest frame, 1/(m rad)
    };

    /// Shell and folds must outlive this object.
    FaceCurvature(const Shell& shell, const Folds& folds);

    /// Must be called when the shell has changed. Computes only the faces again that depend on a part of the
    /// change, and returns these faces by ascending number.
    std::vector<Index> follow(const ShellChange& change);

    /// Terms of the change of curvature of a face.
    std::span<const Term> terms(std::size_t face) const { return faces[face]; }
    /// The change of curvature of a face, (00, 11, 2 * 01), 1/m. changes: changes of all folds' angles, rad.
    Vector3d of(std::size_t face, const VectorXd& changes) const {
        Vector3d sum = Vector3d::Zero();
        for (const Term& term : faces[face]) sum += changes[term.fold] * term.per_angle;
        return sum;
    }

    /// The folds on which the curvatures of some faces depend, ascending.
    std::vector<Index> folds_of(std::span<const Index> some) const;
    /// A column for each side: the curvature of a face, (00, 11, 2 * 01), 1/m, for each radian of the angle
    /// from its facet to the tangent at this side, including the bending at free sides that follows. Columns
    /// of free sides are zero.
    Matrix3d per_tangent(Index face) const;
    /// Weights of folds in the angle from T0's facet to the tangent at an edge with a hinge.
    std::span<const Patches::Share> shares_of_first(Index edge) const { return shares[edge]; }
    /// Whether `side`, which is a side of T0 or T1 at an edge with a hinge, belongs to T0.
    bool is_first(Index edge, const TriangleEdge& side) const {
        const TriangleEdge first = (*patches.sides_of(edge))[0];
        return first.triangle == side.triangle && first.corner == side.corner;
    }

    /// The sides of faces, and the folds at these sides.
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
    /// [E] weights of the folds around an edge in the angle from T0's facet to the tangent at the edge; empty
    /// if the edge has no hinge.
    std::vector<std::vector<Patches::Share>> shares;
    std::vector<std::vector<Term>> faces;  ///< [F] terms of each face's curvature
};

}  // namespace sherd
