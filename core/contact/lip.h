// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/distance.h"
#include "core/energy.h"

namespace sherd {

/// A vertex on one lip of a crack, and the triangle of the other lip: vertices 0 | 1 2 3, the lip being the
/// triangle's side from 1 to 2.
struct LipStencil {
    std::array<Index, 4> vertices;
    double stiffness;  ///< N/m
};

/// How far the vertex is in front of the lip, in the triangle's plane, m; negative when it overlaps.
double lip_opening(const PairPositions& x);
/// d(opening)/dx, [3, 4]; without sum and without torque.
PairPositions lip_opening_gradient(const PairPositions& x);
/// d2(opening)/dx2, 1/m.
PairHessian lip_opening_hessian(const PairPositions& x);

/// What holds the lips of a crack apart as long as they are too near for SheetContact: a spring against
/// overlap, none against opening or sliding. The convex Hessian is the Gauss-Newton one.
class LipContact : public Energy {
  public:
    /// The stencils must outlive it.
    explicit LipContact(const std::vector<LipStencil>& lips) : lips(lips) {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

    double largest_overlap(const Positions& x) const;  ///< m, 0 when nothing overlaps

  private:
    const std::vector<LipStencil>& lips;
};

}  // namespace sherd
