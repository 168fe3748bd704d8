// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/block_matrix.h"
#include "core/shell_change.h"
#include "core/step_context.h"
#include "core/time_spent.h"

namespace sherd {

/// Which second derivative an energy hands to the minimiser.
enum class Curvature {
    exact,  ///< the Hessian; may be indefinite
    convex  ///< a positive semidefinite matrix near it, which makes every step one of descent
};

/// A potential energy of the vertex positions. Between two calls of begin(), topology_changed() and
/// moved_to() its answers depend on the positions alone, not on what was asked before.
struct Energy {
    virtual ~Energy() = default;
    /// Makes ready for a step, whose beginning the shell's positions and velocities are.
    virtual void begin(const StepContext& /*step*/) {}
    /// To be called when the shell has other vertices, hinges or lips, to go on with the same step.
    virtual void topology_changed(const ShellChange& /*change*/, const StepContext& step) { begin(step); }
    /// To be called when the minimiser has moved to x, from where it will go on.
    virtual void moved_to(const Positions& /*x*/) {}

    /// Value in J. x: [3, V] in m.
    virtual double value(const Positions& x) const = 0;
    /// Bound on the round-off error of value(), J, where terms cancel in it.
    virtual double round_off() const { return 0; }
    /// Adds dE/dx, in N, to gradient [3, V]; the force is its negative.
    virtual void add_gradient(const Positions& x, Positions& gradient) const = 0;
    /// Adds d2E/dx2, in N/m.
    virtual void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const = 0;
    /// Appends the pairs of vertices that have a block in the Hessian as long as the shell stays as it is.
    virtual void add_pattern(std::vector<std::pair<Index, Index>>& /*pairs*/) const {}
    /// Appends those that come and go with the positions: the pairs that have a block at x, and, `ahead`,
    /// those that are likely to have one soon.
    virtual void add_contacts(const Positions& /*x*/, bool /*ahead*/,
                              std::vector<std::pair<Index, Index>>& /*pairs*/) const {}
    /// Fraction, 0 to 1, of a straight motion from x up to which the energy stays finite on the whole way.
    virtual double safe_fraction(const Positions& /*x*/, const Positions& /*motion*/) const { return 1; }
    /// What the time that it takes counts for.
    virtual Task task() const { return Task::elasticity; }
};

}  // namespace sherd
