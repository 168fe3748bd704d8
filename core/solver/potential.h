// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// The sum of energies as a function of the free vertices, for a minimiser. Fixed vertices do not take part:
/// their rows of gradient and Hessian are those of the identity. Neither do guided vertices in the directions
/// that their guides block.
class Potential {
  public:
    /// Energies, shell and `spent` must outlive this object. The energies are summed in the given order.
    /// threads: used for Hessians.
    Potential(const Shell& shell, std::vector<Energy*> energies, TimeSpent& spent,
              Threads threads = Threads())
        : shell(shell), energies(std::move(energies)), spent(spent), threads(std::move(threads)) {}

    void begin(const StepContext& step);
    void topology_changed(const ShellChange& change, const StepContext& step);
    void moved_to(const Positions& x);
    /// Contribution of inertia and mass damping to the Hessian in the open step, for each unit of mass,
    /// 1/s^2.
    double hessian_per_mass() const;

    double value(const Positions& x) const;        ///< J
    double round_off() const;                      ///< J, bound on the value's error by cancellation
    Positions gradient(const Positions& x) const;  ///< N, [3, V]
    /// Gradient with the components that pins and guides block, N, [3, V].
    Positions gradient_with_blocked(const Positions& x) const;
    Positions contact_gradient(const Positions& x) const;  ///< N, [3, V], of contact and friction alone
    /// The pairs of vertices that have a block in all Hessians, repeated or not.
    std::vector<std::pair<Index, Index>> pattern() const;
    /// Diagonal blocks of the contribution of contact and friction to the Hessian at x, N/m, [V].
    std::vector<Matrix3d> contact_stiffness(const Positions& x) const;
    /// Zero matrix with the pattern of Hessians at x and nearby.
    BlockMatrix hessian_pattern(const Positions& x) const;
    /// The pairs of vertices that have a block in the Hessian at x because they are in contact.
    std::vector<std::pair<Index, Index>> contacts(const Positions& x) const;
    void hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const;
    /// Sets the matrix to the contribution of contact and friction alone.
    void contact_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const;
    /// Fraction, 0 to 1, of a straight motion from x [3, V] in which nothing passes through a sheet.
    double safe_fraction(const Positions& x, const Positions& motion) const;
    const Shell& mechanics() const { return shell; }
    /// Account of the computing time.
    TimeSpent& time_spent() const { return spent; }

  private:
    /// Calls `action` with each energy, and books the time on its task.
    template <class Action>
    void each(const Action& action) const;

    const Shell& shell;
    std::vector<Energy*> energies;
    TimeSpent& spent;
    Threads threads;
};

}  // namespace sherd
