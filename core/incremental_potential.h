// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/sheet.h"

namespace sherd {

/// The function whose minimum is the end of an implicit Euler step:
///     E(x) = 1 / (2 h^2) (x - y)^T M (x - y) + sum of energies,   y = x_n + h v_n + h^2 g.
/// Fixed vertices do not take part: their rows of gradient and Hessian are those of the identity. They stay
/// where they are, or, when a motion carries them, where x has them, which must be where `predicted` does.
/// Guided vertices stay in the directions that are not free.
class IncrementalPotential {
  public:
    /// All energies, the sheet and `spent` must outlive it. step: s; gravity: m/s^2; end: s, time of the
    /// step's end.
    IncrementalPotential(const Sheet& sheet, std::vector<const Energy*> energies, double step,
                         const Vector3d& gravity, TimeSpent& spent, double end = 0);

    /// y, m; of fixed vertices where they are at the end of the step.
    const Positions& predicted() const { return inertial; }
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

    /// Takes away what pins and guides do not let through.
    void constrain(Positions& displacement) const;

  private:
    /// Does `action` with each energy, and books the time for its task.
    template <class Action>
    void each(const Action& action) const;
    /// Predicts the vertices that motions carry.
    void carry(double end);

    const Sheet& sheet;
    std::vector<const Energy*> energies;
    double step;
    TimeSpent& spent;
    Positions inertial;
};

}  // namespace sherd
