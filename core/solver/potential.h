// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/shell/sheet.h"

namespace sherd {

/// The sum of energies as a function of the vertices that are free: what a minimiser sees. Fixed vertices do
/// not take part: their rows of gradient and Hessian are those of the identity. Guided vertices stay in the
/// directions that are not free.
class Potential {
  public:
    /// All energies, the sheet and `spent` must outlive it. The energies are summed in their order.
    Potential(const Sheet& sheet, std::vector<Energy*> energies, TimeSpent& spent)
        : sheet(sheet), energies(std::move(energies)), spent(spent) {}

    void begin(const StepContext& step);
    void topology_changed(const ShellChange& change, const StepContext& step);
    void moved_to(const Positions& x);

    double value(const Positions& x) const;        ///< J
    double round_off() const;                      ///< bound on the value's error by cancellation, J
    Positions gradient(const Positions& x) const;  ///< N, [3, V]
    /// Zero matrix of the pattern of Hessians at x, and near it.
    BlockMatrix hessian_pattern(const Positions& x) const;
    /// Whether the Hessian at x has no block that the matrix lacks.
    bool fits(const Positions& x, const BlockMatrix& hessian) const;
    void hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const;
    /// Fraction, 0 to 1, of a straight motion from x [3, V] that leads through no sheet.
    double safe_fraction(const Positions& x, const Positions& motion) const;
    /// Where it is booked what time is spent on.
    TimeSpent& time_spent() const { return spent; }

  private:
    /// Does `action` with each energy, and books the time for its task.
    template <class Action>
    void each(const Action& action) const;

    const Sheet& sheet;
    std::vector<Energy*> energies;
    TimeSpent& spent;
};

}  // namespace sherd
