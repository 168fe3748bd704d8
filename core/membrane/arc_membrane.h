// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/arc_triangle.h"
#include "core/membrane/side_curvature.h"
#include "core/state_visitor.h"

namespace sherd {

/// Membrane energy of triangles with arcs for sides (arc_triangle.h), which do not lock where thin curved
/// sheets bend: the curvature along the sides follows from the dihedral angles around (SideCurvature). The
/// rest lengths of the arcs are computed from the curvature of the rest shape in the same manner, also beside
/// cracks: an unloaded sheet stays unloaded. Angles are taken between -pi and pi; a fold that passes pi makes
/// the energy jump.
class ArcMembrane : public Energy {
  public:
    /// The shell must outlive this object. mirrors: they continue the sheet, as they do for coupled hinges.
    ArcMembrane(const Shell& shell, const std::vector<MirrorHinge>& mirrors);
    ArcMembrane(const ArcMembrane&) = delete;  // members refer to each other
    /// Measures strain from the shape x instead of the rest shape, and multiplies the energy by `scale`,
    /// until the shell changes.
    void start_from(const Positions& x, double scale);

    /// Green strain of each face, [3, F]: (00, 11, 2 * 01) in the face's rest frame.
    Eigen::Matrix3Xd strains(const Positions& x) const;
    /// See Folds::mirror_gradients().
    std::vector<MirrorGradient> mirror_gradients(const Positions& x) const;

    void begin(const StepContext& step) override { folds.begin(step); }
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, folds, curvature, triangles] = *this;
        visit(folds, curvature, triangles);
    }

  private:
    void measure_from_rest();
    TrianglePositions corners(const Positions& x, std::size_t face) const;
    std::vector<ArcGradient> gradients(const Positions& x, const VectorXd& angles) const;  ///< [F]
    /// The derivative of the energy by the angles of all folds, N m. of_faces: gradients().
    VectorXd moments(const std::vector<ArcGradient>& of_faces) const;

    const Shell& shell;
    Folds folds;
    SideCurvature curvature;
    std::vector<ArcTriangle> triangles;  ///< [F]
};

}  // namespace sherd
