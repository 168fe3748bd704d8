// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// An energy E whose forces are those in the middle of a step that begins at x0: as a function of the
/// positions x at its end 2 E((x0 + x) / 2), with the gradient of E in the middle, and half of its Hessian.
class MiddleEnergy : public Energy {
  public:
    /// Both must outlive this object.
    MiddleEnergy(const Shell& shell, Energy& energy) : shell(shell), energy(energy) {}
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    void moved_to(const Positions& x) override;
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    /// The energy is visited by whose it is.
    void visit_state(StateVisitor& visit) override {
        [[maybe_unused]] auto& [shell, energy] = *this;
        visit();
    }

  private:
    Positions middle(const Positions& x) const { return 0.5 * (shell.position + x); }

    const Shell& shell;
    Energy& energy;
};

}  // namespace sherd
