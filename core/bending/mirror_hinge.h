// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/bending/cubic_hinge.h"
#include "core/energy.h"
#include "core/shell/triangle_edge.h"
#include "core/state_visitor.h"

namespace sherd {

/// The hinge between a triangle and its mirror image in a plane through one of its sides; half of its energy
/// is counted. The image continues the sheet beyond the side, so that the sheet can move but not tilt there:
/// with the side's ends fixed this is a clamp, with the ends sliding in the plane a symmetry plane. A mirror
/// hinge does not break.
struct MirrorHinge {
    TriangleEdge side;
    Vector3d normal;   ///< unit normal of the plane, which contains the side at rest
    double offset;     ///< m, normal . x for points x of the plane
    double stiffness;  ///< lambda, N m
    Index script = 0;  ///< 0, or the number, from 1, of the prescribed motion of the plane
};

/// The hinge that clamps a side: it keeps the tangent across the side that the sheet has at rest. The side's
/// ends must be fixed, or follow one prescribed motion, which then moves this tangent, too. stiffness:
/// lambda, N m.
MirrorHinge clamp_hinge(const Shell& shell, const TriangleEdge& side, double stiffness);

/// The hinge across a symmetry plane through the side. normal: unit length. stiffness: lambda, N m.
MirrorHinge symmetry_hinge(const Shell& shell, const TriangleEdge& side, const Vector3d& normal,
                           double stiffness);

/// The mirror hinges of a shell. In a step their planes are at their places at the end of the step.
class Mirrors {
  public:
    /// The shell must outlive this object.
    Mirrors(const Shell& shell, std::vector<MirrorHinge> hinges);
    void begin(const StepContext& step);
    /// Must be called when the shell has changed. Where a mirror's side was split, its second part is
    /// appended.
    void follow(const ShellChange& change);

    std::size_t size() const { return hinges.size(); }
    const MirrorHinge& operator[](std::size_t i) const { return hinges[i]; }
    /// Number of the original mirror, as given to the constructor, of which mirror i is the whole or a part.
    std::size_t origin(std::size_t i) const { return origins[i]; }
    std::array<Index, 3> vertices(std::size_t i) const { return edge_and_apex(shell, hinges[i].side); }
    /// Positions, m, of the hinge that the triangle and its image form.
    HingePositions with_image(std::size_t i, const Positions& x) const;
    /// Positions, m, of this hinge at rest, where the plane contains the side.
    HingePositions rest(std::size_t i) const;
    /// Derivative of the image's apex by the apex; for the other vertices of the hinge it is the identity.
    Matrix3d reflection(std::size_t i) const;
    /// Converts a Hessian by the positions of the hinge's four vertices to a Hessian by the positions of the
    /// triangle's three vertices, [9, 9].
    Eigen::Matrix<double, 9, 9> folded(std::size_t i, const HingeHessian& hessian) const;
    void visit_state(StateVisitor& visit) {
        auto& [shell, at_rest, hinges, origins] = *this;
        visit(at_rest, hinges, origins);
    }

  private:
    const Shell& shell;
    std::vector<MirrorHinge> at_rest, hinges;  ///< with planes at rest; with planes at the end of the step
    std::vector<std::size_t> origins;
};

/// The derivative of a mirror hinge's energy by the positions of `vertices`, N; the hinge's forces on them
/// are its negative. A vertex may occur twice; -1: no vertex.
struct MirrorGradient {
    std::array<Index, 4> vertices;
    HingePositions gradient;
};

/// Bending energy of all mirror hinges, which are cubic hinges.
class MirrorEnergy : public Energy {
  public:
    /// The shell must outlive this object.
    MirrorEnergy(const Shell& shell, std::vector<MirrorHinge> hinges);
    std::vector<MirrorGradient> gradients(const Positions& x) const;  ///< gradient of each hinge
    void begin(const StepContext& step) override { mirrors.begin(step); }
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

    const Mirrors& all() const { return mirrors; }  ///< with their planes in the open step
    void visit_state(StateVisitor& visit) override {
        auto& [mirrors, bending] = *this;
        visit(mirrors, bending);
    }

  private:
    void find_bending();

    Mirrors mirrors;
    std::vector<CubicHinge> bending;  ///< bending energy of each mirror hinge
};

}  // namespace sherd
