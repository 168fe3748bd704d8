// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// The sum of energies as a function of the free vertices and bodies, for a minimiser. Fixed vertices do not
/// take part: their rows of the gradient are zero, and their rows of the Hessian are rows of the identity.
/// Guided vertices do not take part in the directions that their guides block. The unknowns x are [3, N] m:
/// the V vertices of the shell, then two columns for each body (BodyColumns).
class Potential {
  public:
    /// Energies, shell and `spent` must outlive this object. The energies are summed in the given order.
    /// threads: used for Hessians. body_masses: masses of the free bodies, kg.
    Potential(const Shell& shell, std::vector<Energy*> energies, TimeSpent& spent,
              Threads threads = Threads(), std::vector<double> body_masses = {})
        : shell(shell),
          energies(std::move(energies)),
          spent(spent),
          threads(std::move(threads)),
          body_masses(std::move(body_masses)) {}

    void begin(const StepContext& step);
    void topology_changed(const ShellChange& change, const StepContext& step);
    /// Contribution of inertia and mass damping to each diagonal entry of the Hessian in the open step,
    /// divided by the vertex's mass, 1/s^2.
    double hessian_per_mass() const;

    double value(const Positions& x) const;        ///< J
    double round_off() const;                      ///< J, bound on the value's error by cancellation
    Positions gradient(const Positions& x) const;  ///< N, [3, N]
    /// Gradient, N, [3, N], including the components that pins and guides block.
    Positions gradient_with_blocked(const Positions& x) const;
    /// Gradient of the energies of contact and friction, N, [3, N].
    Positions contact_gradient(const Positions& x) const;
    /// The pairs of columns that have a block in the Hessian at all positions; a pair may be repeated.
    std::vector<std::pair<Index, Index>> pattern() const;
    /// Diagonal blocks of the contribution of contact and friction to the Hessian at x, N/m, [N].
    std::vector<Matrix3d> contact_stiffness(const Positions& x) const;
    /// Zero matrix with the pattern of Hessians at x and nearby.
    BlockMatrix hessian_pattern(const Positions& x) const;
    /// The pairs of columns that have a block in the Hessian at x because they are in contact.
    std::vector<std::pair<Index, Index>> contacts(const Positions& x) const;
    void hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const;
    /// Sets the matrix to the contribution of contact and friction alone.
    void contact_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const;
    /// Fraction, 0 to 1, of a straight motion of the unknowns from x, [3, N] m, up to which nothing passes
    /// through a sheet or a body.
    double safe_fraction(const Positions& x, const Positions& motion) const;
    const Shell& mechanics() const { return shell; }
    /// Number of the columns of bodies.
    Index body_columns() const { return static_cast<Index>(2 * body_masses.size()); }
    /// Mass, kg, that moves with each column, [N]; 0 for the rotations of bodies.
    VectorXd masses() const;
    /// Account of the computing time.
    TimeSpent& time_spent() const { return spent; }

  private:
    /// Calls `action` with each energy, and adds the computing time to the account of the energy's task.
    template <class Action>
    void each(const Action& action) const;
    /// Calls `action` with each energy and its positions: x if the energy has bodies, else the columns of x
    /// that belong to vertices.
    template <class Action>
    void each(const Positions& x, const Action& action) const;
    /// The sum of the gradients of all energies or, if `of_contact`, of the energies of contact and friction.
    Positions sum_of_gradients(const Positions& x, bool of_contact) const;

    const Shell& shell;
    std::vector<Energy*> energies;
    TimeSpent& spent;
    Threads threads;
    std::vector<double> body_masses;
};

}  // namespace sherd
