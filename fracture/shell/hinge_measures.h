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
    /// Tensile strain across the edge, at the surface where it is larger, over half the thickness, 1/m.
    double strain = 0;
    double stress = 0;  ///< Pa, tensile stress across the edge at the surface where it is larger

    double of(Measure measure) const;
};

/// The measures of all hinges, each [H] in the order of mechanics().hinges: see HingeMeasure.
struct HingeMeasures {
    VectorXd bending, strain, stress;

    HingeMeasure at(Index hinge) const { return {bending[hinge], strain[hinge], stress[hinge]}; }
    double of(Measure measure, Index hinge) const { return at(hinge).of(measure); }
    void visit_state(StateVisitor& visit) {
        auto& [bending, strain, stress] = *this;
        visit(bending, strain, stress);
    }
};

/// Computes the measures of all hinges at the positions x, [3, V] m. Strain and stress of a hinge are
/// computed from the means, over its two faces, of the faces' Green strain and change of curvature across the
/// edge. `strain` is the Green strain over half the thickness, plus the magnitude of the change of curvature;
/// `stress` is the stress at the surface by the membrane's plane-stress elasticity. In pure bending `strain`
/// is a curvature, like the paper's measure `bending`; unlike `bending`, it includes in-plane stretch, and
/// the bending of a face as a whole. curvatures: [3, F] 1/m, the faces' changes of curvature, (00, 11, 2 *
/// 01) in their rest frames (ShellEnergies::coupled_curvatures()); if they are not given, they follow from
/// the changes of the angles of each face's own hinges, as for uncoupled hinges. strains: [3, F], the faces'
/// Green strain (ShellEnergies::face_strains()); if it is not given, it follows from the faces' corners.
/// plastic: [3, F] 1/m, plastic part of the faces' curvature (ShellEnergies::plastic_curvatures()), which
/// adds to the strain and not to the stress.
HingeMeasures hinge_measures(const BreakableShell& shell, const Positions& x,
                             const std::optional<Eigen::Matrix3Xd>& curvatures = {},
                             const std::optional<Eigen::Matrix3Xd>& strains = {},
                             const std::optional<Eigen::Matrix3Xd>& plastic = {});

/// The two faces of a hinge: T0 and T1.
std::array<Index, 2> faces_of_hinge(const BreakableShell& shell, Index hinge);
/// Returns the measures of a single hinge, with the same bits as hinge_measures(). curvatures, strains,
/// plastic: as there, but [3, 2], of the two faces of the hinge alone.
HingeMeasure hinge_measure(const BreakableShell& shell, Index hinge, const Positions& x,
                           const std::optional<Eigen::Matrix3Xd>& curvatures, const Eigen::Matrix3Xd& strains,
                           const std::optional<Eigen::Matrix3Xd>& plastic);

}  // namespace sherd
