// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/block_matrix.h"
#include "core/time_spent.h"
#include "core/vector.h"

namespace sherd {

/// Which second derivative an energy hands to Newton's method.
enum class Curvature {
    exact,  ///< the Hessian; may be indefinite
    convex  ///< a positive semidefinite matrix near it, which makes every step one of descent
};

/// A potential energy of the vertex positions: the sum over the stencils of one kind of element.
struct Energy {
    virtual ~Energy() = default;
    /// Value in J. x: [3, V] in m.
    virtual double value(const Positions& x) const = 0;
    /// Bound on the round-off error of value(), J, where terms cancel in it.
    virtual double round_off() const { return 0; }
    /// Adds dE/dx, in N, to gradient [3, V]; the force is its negative.
    virtual void add_gradient(const Positions& x, Positions& gradient) const = 0;
    /// Adds d2E/dx2, in N/m.
    virtual void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const = 0;
    /// Appends the pairs of vertices that have a block in the Hessian.
    virtual void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const = 0;
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
