// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/coupled_bending.h"
#include "core/bending/cubic_polynomial.h"
#include "core/bending/fold_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// The bending energy of coupled hinges (CoupledBending) with the polynomial of CubicFace for each face where
/// this is safe, and the true angles for the others. Each face's energy is by itself zero and in equilibrium
/// at rest, and without net force and torque, so that the two go together.
class CoupledCubicBending : public Energy {
  public:
    /// How the energy of a face is computed.
    enum class Form : char {
        polynomial,
        beside_mirror,  ///< true angles: the face sees a clamp or a symmetry plane, which may move
        crease,         ///< true angles: a fold around is turned by 45 degrees or more at rest
        thick,          ///< true angles: the sheet is thicker than a quarter of the face's shortest side
        unsuited        ///< true angles: there is no well conditioned polynomial
    };

    /// The shell must outlive this object.
    CoupledCubicBending(const Shell& shell, const std::vector<MirrorHinge>& mirrors);

    /// The hinges, whose changes of curvature are those of all faces.
    const CoupledBending& hinges() const { return angles; }
    const std::vector<Form>& forms() const { return form; }  ///< [F]

    void begin(const StepContext& step) override { angles.begin(step); }
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override { return angles.value(x) + polynomial.value(x); }
    double round_off() const override { return angles.round_off() + polynomial.round_off(); }
    void add_gradient(const Positions& x, Positions& gradient) const override;
    /// Curvature::convex: the positive part of each face's constant matrix, and that of CoupledBending.
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, angles, form, of_face, polynomial] = *this;
        visit(angles, form, of_face, polynomial);
    }

  private:
    /// What a face adds to the polynomial. Vertices change with cracks, corners of triangles do not.
    struct FacePolynomial {
        std::vector<FoldTree::Corner> corners = {};
        std::vector<std::array<double, 2>> springs =
            {};  ///< N/m, as in Spring, of corners 1-0, 2-0, 2-1, ...
        std::vector<std::pair<Index, double>> triples = {};  ///< edges with a hinge, and their k, N/m^2
        double constant = 0;                                 ///< J

        void visit_state(StateVisitor& visit) {
            auto& [corners, springs, triples, constant] = *this;
            visit(corners, springs, triples, constant);
        }
    };

    void update(Index face);
    void assemble();
    std::vector<Index> folds_of(Index face) const;
    Form form_of(Index face, const std::vector<Index>& folds) const;
    Eigen::MatrixXd stiffness(Index face, const FoldTree& tree) const;

    const Shell& shell;
    CoupledBending angles;                ///< its energy is that of the other faces
    std::vector<Form> form;               ///< [F]
    std::vector<FacePolynomial> of_face;  ///< [F]
    CubicPolynomial polynomial;           ///< the sum of all
};

/// The coupled hinges of a bending energy; null: it has none.
const CoupledBending* coupled_hinges(const Energy& bending);

}  // namespace sherd
