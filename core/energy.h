// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/block_matrix.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/step_context.h"
#include "core/time_spent.h"

namespace sherd {

/// The second derivative that an energy gives to the minimiser.
enum class Curvature {
    exact,  ///< the Hessian, which may be indefinite
    convex  ///< a positive semidefinite approximation, with which every step is a descent
};

/// A potential energy of the vertex positions. Between calls of begin() and topology_changed(), its results
/// depend on the positions alone and not on earlier calls.
struct Energy {
    virtual ~Energy() = default;
    /// Prepares for a step, which begins at the shell's positions and velocities.
    virtual void begin(const StepContext& /*step*/) {}
    /// Must be called after a change of the shell's vertices, hinges or crack faces; the open step continues.
    virtual void topology_changed(const ShellChange& /*change*/, const StepContext& step) { begin(step); }
    /// Whether positions, gradients and Hessians in the functions below include the columns of the free
    /// bodies (BodyColumns), after the columns of the V vertices.
    virtual bool has_bodies() const { return false; }

    /// Energy, J. x: [3, V] m.
    virtual double value(const Positions& x) const = 0;
    /// Bound on the round-off error of value() by cancellation, J.
    virtual double round_off() const { return 0; }
    /// Adds dE/dx, N, to gradient [3, V]; the force is its negative.
    virtual void add_gradient(const Positions& x, Positions& gradient) const = 0;
    /// Adds d2E/dx2 at x, N/m, or its convex approximation.
    virtual void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const = 0;
    /// Appends the pairs of vertices that have a block in the Hessian at all positions, until the shell
    /// changes.
    virtual void add_pattern(std::vector<std::pair<Index, Index>>& /*pairs*/) const {}
    /// Appends at least those of these pairs that belong to elements all of whose vertices v have among[v] !=
    /// 0.
    virtual void add_pattern_among(const std::vector<char>& /*among*/,
                                   std::vector<std::pair<Index, Index>>& pairs) const {
        add_pattern(pairs);
    }
    /// Appends the pairs of vertices whose blocks depend on the positions: the pairs with a block in the
    /// Hessian at x and, if `ahead`, also the pairs that are likely to have a block after small motions.
    virtual void add_contacts(const Positions& /*x*/, bool /*ahead*/,
                              std::vector<std::pair<Index, Index>>& /*pairs*/) const {}
    /// Fraction, 0 to 1, of a straight motion from x up to which the energy stays finite.
    virtual double safe_fraction(const Positions& /*x*/, const Positions& /*motion*/) const { return 1; }
    /// Contribution of inertia and mass damping to each diagonal entry of the Hessian, divided by the
    /// vertex's mass, 1/s^2. Forces of the air, which are proportional to area, are not included.
    virtual double hessian_per_mass() const { return 0; }
    /// The task to whose account the energy's computing time is added.
    virtual Task task() const { return Task::elasticity; }

    /// Visits the state that begin() does not compute.
    virtual void visit_state(StateVisitor& visit) = 0;
};

}  // namespace sherd
