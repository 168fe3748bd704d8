// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/state_visitor.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Bending strain of each hinge (paper, appendix B), signed, 1/m, in the order of mechanics().hinges. x: [3,
/// V] m.
VectorXd hinge_strains(const BreakableShell& shell, const Positions& x);

/// The measures by which hinges fail, [H] each, in the order of mechanics().hinges.
struct HingeMeasures {
    VectorXd bending;  ///< magnitude of the bending strain, 1/m
    VectorXd strain;   ///< 1/m, tensile strain across the edge, at the surface where it is larger, over t / 2
    VectorXd stress;   ///< Pa, tensile stress across the edge at the surface where it is larger

    /// The given measure of a hinge.
    double of(Measure measure, Index hinge) const;
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
/// them it follows from the faces' corners. kept: plastic part of the faces' curvature
/// (ShellEnergies::kept_curvatures()), which adds to the strain and not to the stress. x: [3, V] m.
HingeMeasures hinge_measures(const BreakableShell& shell, const Positions& x,
                             const std::optional<Eigen::Matrix3Xd>& curvatures = {},
                             const std::optional<Eigen::Matrix3Xd>& strains = {},
                             const std::optional<Eigen::Matrix3Xd>& kept = {});

}  // namespace sherd
