// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/bending/cubic_hinge.h"
#include "core/energy.h"
#include "core/shell/sides.h"

namespace sherd {

/// The hinge between a triangle and its image in a plane through one of its sides; half of its energy is the
/// triangle's. It makes the sheet go on beyond the side like its mirror image, so that it can move but not
/// tilt there: with the side's ends fixed this is a clamp, with the ends sliding in the plane a symmetry
/// plane. It does not break.
struct MirrorHinge {
    TriangleSide side;
    Vector3d normal;    ///< of the plane, unit length; at rest the plane has the side in it
    double offset;      ///< m, normal . x of the plane's points
    double stiffness;   ///< lambda, N m
    Index carrier = 0;  ///< 0, or the number, from 1, of the motion that carries the plane
};

/// The hinge that holds the sheet's rest tangent across a side whose ends are fixed, or carried by one
/// motion, which then carries the tangent, too. stiffness: lambda, N m.
MirrorHinge clamp_hinge(const Sheet& sheet, const TriangleSide& side, double stiffness);

/// The hinge across a symmetry plane through the side. normal: unit length. stiffness: lambda, N m.
MirrorHinge symmetry_hinge(const Sheet& sheet, const TriangleSide& side, const Vector3d& normal,
                           double stiffness);

/// Bending energy of all mirror hinges, which are cubic ones; their planes stand where they are at the end of
/// the step.
class MirrorEnergy : public Energy {
  public:
    /// The sheet must outlive it.
    MirrorEnergy(const Sheet& sheet, std::vector<MirrorHinge> hinges);
    void begin(const StepContext& step) override;
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    HingePositions mirrored(const MirrorHinge& hinge, const Positions& x) const;

    const Sheet& sheet;
    std::vector<MirrorHinge> at_rest, hinges;  ///< the same, with the planes at rest and where they are now
    std::vector<CubicHinge> bending;           ///< of each
};

}  // namespace sherd
