// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solver/potential.h"
#include "core/state_visitor.h"

namespace sherd {

struct MinimiserResult {
    int iterations = 0;
    bool converged = false;
    bool limited = false;   ///< whether it ended because of the limit on iterations
    double correction = 0;  ///< m, largest coordinate of the last correction
};

/// Finds the minimum of a potential. It may keep patterns, orderings and factors from one call to the next,
/// so that changes must be passed to topology_changed().
struct Minimiser {
    virtual ~Minimiser() = default;
    /// Must be called when vertices were added or hinges removed: the potential has another pattern, and the
    /// next minimisation starts near x [3, V] m.
    virtual void topology_changed(const ShellChange& change, const Potential& potential,
                                  const Positions& x) = 0;
    /// Moves x [3, V] m towards the minimum, in at most `max_iterations` iterations of Newton's method or
    /// iterations of another one that take as long. The potential must be finite at x; it stays finite along
    /// every motion.
    virtual MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) = 0;
    /// Sets the tolerance, m, of the largest coordinate of the last correction.
    virtual void set_tolerance(double tolerance) = 0;
    virtual void visit_state(StateVisitor& visit) = 0;
};

}  // namespace sherd
