// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/face_curvature.h"
#include "core/bending/yielding_section.h"
#include "core/block_columns.h"
#include "core/state_visitor.h"

namespace sherd {

/// The bending energy of coupled hinges: for each face, half its area times
///     k^T D k,
/// with the face's change of curvature k (FaceCurvature) and the plate's rigidity D: the membrane's
/// elasticity times t^2 / 12. As a function of the changes of all angles, dtheta, the energy is 1/2 dtheta^T
/// S dtheta with a constant matrix S. Angles are true dihedral angles, so that rigid motions do not change
/// the energy and the rest shape is an equilibrium; a change of angle is taken between -pi and pi. Clamps and
/// symmetry planes are folds, too.
class CoupledBending : public Energy {
  public:
    /// The shell must outlive this object.
    CoupledBending(const Shell& shell, const std::vector<MirrorHinge>& mirrors);
    CoupledBending(const CoupledBending&) = delete;  // members refer to each other
    /// Measures changes of angles from the shape x instead of the rest shape, and multiplies the energy by
    /// `scale`.
    void start_from(const Positions& x, double scale);
    /// Makes faces bend plastically beyond the yield stress of their sheet (YieldingSection), beginning at
    /// the shell's positions. yield_of_sheet: Pa, for each sheet; 0: the sheet does not yield.
    void set_yield(std::vector<double> yield_of_sheet);
    /// Part of value() that yielding dissipates in a step that ends at x, J.
    double dissipated_by_yielding(const Positions& x) const;
    /// Must be called when a step ends at x: stores the plastic curvatures.
    void store_plastic_curvature(const Positions& x);

    /// Changes of the angles of all folds, rad.
    VectorXd changes(const Positions& x) const { return changes(x, folds.present()); }
    /// Change of curvature of each face, [3, F], 1/m: (00, 11, 2 * 01) in the face's rest frame, less its
    /// plastic curvature.
    Eigen::Matrix3Xd curvatures(const Positions& x) const;
    /// Plastic curvature of each face in a step that ends at x, [3, F], 1/m.
    Eigen::Matrix3Xd plastic_curvatures(const Positions& x) const;
    // Variants for the faces `some`, with a column for each of them.
    Eigen::Matrix3Xd curvatures(const Positions& x, std::span<const Index> some) const {
        return curvatures_at(some, changes(x, curvature.folds_of(some)));
    }
    Eigen::Matrix3Xd plastic_curvatures(const Positions& x, std::span<const Index> some) const {
        return kept_at(some, changes(x, curvature.folds_of(some)));
    }

    const Folds& all_folds() const { return folds; }
    /// Angle from which changes of a fold's angle are measured, rad.
    double start_angle(Index fold) const { return start[fold]; }
    const FaceCurvature& face_curvature() const { return curvature; }
    /// Matrix D of the elastic stiffness of a face against a change k of its curvature, J m^2: its energy is
    /// k^T D k / 2.
    Matrix3d rigidity(Index face) const {
        return rigidity_factor(face) * shell.triangles[face].membrane.elasticity;
    }

    /// See Folds::mirror_gradients().
    std::vector<MirrorGradient> mirror_gradients(const Positions& x) const;

    void begin(const StepContext& step) override { folds.begin(step); }
    /// If triangles have changed, all changes of angles are measured from the rest shape again.
    void topology_changed(const ShellChange& change, const StepContext&) override;
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    void add_pattern_among(const std::vector<char>& among,
                           std::vector<std::pair<Index, Index>>& pairs) const override;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, folds, curvature, present, start, scale, yields, plastic, reach, reach_is_valid,
               slopes] = *this;
        visit(folds, curvature, present, start, scale, plastic);
        if (visit.reads()) invalidate_reach();
    }

  private:
    /// The vertices on which the curvature of a face depends.
    struct Reach {
        std::vector<Index> vertices;               ///< ascending
        std::vector<std::array<Index, 4>> places;  ///< for each term's fold, indices of its vertices in
                                                   ///< `vertices`; -1: no vertex
    };

    Index faces() const { return static_cast<Index>(shell.triangles.size()); }
    const std::vector<Reach>& reach_of_faces() const;
    void invalidate_reach();
    /// Clears the reach of faces that have changed, and of faces that depend on vertices that a crack has
    /// split.
    void invalidate_reach(const ShellChange& change, std::span<const Index> changed);
    /// The present folds all of whose vertices belong to a matrix, which may be a part.
    std::vector<Index> present_in(const BlockMatrix& hessian) const;
    /// Writes to `of_face` the derivative of a face's curvature by the positions of the vertices in its
    /// reach, times the root of the face's stiffness, sqrt(J) / m. of_folds: slopes of all folds; changes:
    /// see stiffness().
    void find_slopes(Index face, const std::vector<Folds::Slope>& of_folds, const VectorXd& changes,
                     BlockMatrix::Columns::Rows& of_face) const;
    VectorXd changes(const Positions& x, std::span<const Index> some) const {
        return changes_from(folds.angles(x, some));
    }
    VectorXd changes_from(const VectorXd& angles) const;
    /// Curvatures and plastic curvatures of some faces. changes: changes of the angles of all folds, rad;
    /// entries of folds on which none of these faces depends are not used.
    Eigen::Matrix3Xd curvatures_at(std::span<const Index> some, const VectorXd& changes) const;
    Eigen::Matrix3Xd kept_at(std::span<const Index> some, const VectorXd& changes) const;
    double rigidity_factor(Index face) const;  ///< m^4, rigidity() over the membrane's elasticity
    bool yields_at(Index face) const { return !yields.empty() && yields[shell.face_sheet[face]] > 0; }
    YieldingSection section(Index face) const;
    YieldingSection::State yielded(Index face, const Vector3d& bent) const {
        return section(face).at(bent, plastic[face]);
    }
    /// The derivative of a face's energy by its curvature, J m. bent: change of curvature, 1/m.
    Vector3d moment(Index face, const Vector3d& bent) const {
        if (yields_at(face)) return shell.triangles[face].membrane.area * yielded(face, bent).moment;
        return rigidity_factor(face) * (shell.triangles[face].membrane.elasticity * bent);
    }
    /// The second derivative of a face's energy by its curvature, J m^2, positive definite. changes: changes
    /// of the angles of all folds, rad, used only if the face yields.
    Matrix3d stiffness(Index face, const VectorXd& changes) const;
    VectorXd moments(const VectorXd& changes) const;

    const Shell& shell;
    Folds folds;
    FaceCurvature curvature;
    std::vector<Index> present;  ///< Folds::present()
    VectorXd start;              ///< angles of all folds, rad, from which changes are measured
    double scale = 1;
    std::vector<double> yields;        ///< Pa, yield stress of each sheet; empty: nothing yields
    std::vector<PlasticBend> plastic;  ///< [F] plastic bending of each face; empty: nothing yields
    /// [F] reach of each face, computed on demand; an outdated entry has no vertices.
    mutable std::vector<Reach> reach;
    mutable bool reach_is_valid = false;
    mutable std::vector<Folds::Slope> slopes;  ///< buffer, kept to save allocations
};

}  // namespace sherd
