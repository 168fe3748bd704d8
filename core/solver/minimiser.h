// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solver/potential.h"
#include "core/state_visitor.h"

namespace sherd {

struct MinimiserResult {
    int iterations = 0;
    bool converged = false;
    bool limited = false;   ///< whether the minimisation ended because of the limit on iterations
    double correction = 0;  ///< m, largest coordinate of the last correction
};

/// Finds the minimum of a potential. It may keep patterns, orderings and factors from one call to the next,
/// so that changes of the shell must be passed to topology_changed().
struct Minimiser {
    virtual ~Minimiser() = default;
    /// Must be called when vertices were added or hinges removed: the Hessian then has another pattern, and
    /// the next minimisation starts near x, [3, N] m (see Potential).
    virtual void topology_changed(const ShellChange& change, const Potential& potential,
                                  const Positions& x) = 0;
    /// Moves x, [3, N] m, towards the minimum, in at most as many iterations as take the time of
    /// `max_iterations` iterations of Newton's method. The potential must be finite at x, and stays finite
    /// along the motion of x.
    virtual MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) = 0;
    /// Sets the tolerance, m, of the largest coordinate of the last correction.
    virtual void set_tolerance(double tolerance) = 0;
    virtual void visit_state(StateVisitor& visit) = 0;
};

}  // namespace sherd
