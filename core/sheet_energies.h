// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/sheet.h"

namespace sherd {

/// Bending energy of all hinges of a sheet.
class BendingEnergy : public Energy {
  public:
    explicit BendingEnergy(const std::vector<HingeStencil>& hinges) : hinges(hinges) {}
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    const std::vector<HingeStencil>& hinges;
};

/// Membrane energy of all triangles of a sheet.
class MembraneEnergy : public Energy {
  public:
    explicit MembraneEnergy(const std::vector<TriangleStencil>& triangles) : triangles(triangles) {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    const std::vector<TriangleStencil>& triangles;
};

}  // namespace sherd
