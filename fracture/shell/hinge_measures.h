// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/state_visitor.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Bending strain of each hinge (paper, appendix B), signed, 1/m, in the order of mechanics().hinges. x: [3,
/// V] m.
VectorXd hinge_strains(const BreakableShell& shell, const Positions& x);

/// The measures by which a hinge fails.
struct HingeMeasure {
    double bending = 0;  ///< magnitude of the bending strain, 1/m
    double strain =
        0;  ///< 1/m, tensile strain across the edge, at the surface where it is larger, over t / 2
    double stress = 0;  ///< Pa, tensile stress across the edge at the surface where it is larger

    double of(Measure measure) const;
};

/// The measures of all hinges, [H] each, in the order of mechanics().hinges: see HingeMeasure.
struct HingeMeasures {
    VectorXd bending, strain, stress;

    HingeMeasure at(Index hinge) const { return {bending[hinge], strain[hinge], stress[hinge]}; }
    double of(Measure measure, Index hinge) const { return at(hinge).of(measure); }
    void visit_state(StateVisitor& visit) {
        auto& [bending, strain, stress] = *this;
        visit(bending, strain, stress);
    }
};

/// Computes strain and stress of all hinges. They are means over the edge's two faces of the component across
/// the edge of their Green strain plus half the thickness times their change of curvature; the stress follows
/// with the membrane's plane-stress elasticity. curvatures: the faces' changes of curvature, [3, F], 1/m, as
/// (00, 11, 2 * 01) in their rest frames (ShellEnergies::coupled_curvatures()); without them they follow from
/// the changes of the angles of each face's own hinges, as for uncoupled hinges. In pure bending `strain` is
/// a curvature, like the paper's measure; unlike the paper's, it includes in-plane stretch, and the bending
/// of a face as a whole. strains: the faces' Green strain, [3, F] (ShellEnergies::face_strains()); without
/// them it follows from the faces' corners. plastic: plastic part of the faces' curvature
/// (ShellEnergies::plastic_curvatures()), which adds to the strain and not to the stress. x: [3, V] m.
HingeMeasures hinge_measures(const BreakableShell& shell, const Positions& x,
                             const std::optional<Eigen::Matrix3Xd>& curvatures = {},
                             const std::optional<Eigen::Matrix3Xd>& strains = {},
                             const std::optional<Eigen::Matrix3Xd>& plastic = {});

/// The two faces of a hinge: T0 and T1.
std::array<Index, 2> faces_of_hinge(const BreakableShell& shell, Index hinge);
/// hinge_measures() of a single hinge, to the last bit. curvatures, strains, plastic: [3, 2], of its faces.
HingeMeasure hinge_measure(const BreakableShell& shell, Index hinge, const Positions& x,
                           const std::optional<Eigen::Matrix3Xd>& curvatures, const Eigen::Matrix3Xd& strains,
                           const std::optional<Eigen::Matrix3Xd>& plastic);

}  // namespace sherd
