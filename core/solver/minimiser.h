// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solver/potential.h"

namespace sherd {

struct MinimiserResult {
    int iterations = 0;
    bool converged = false;
    double correction = 0;  ///< m, largest coordinate of the last correction
};

/// What finds the minimum of a potential. It may keep from one call to the next what saves it work (patterns,
/// orderings, factors), which is why it is told of changes.
struct Minimiser {
    virtual ~Minimiser() = default;
    /// To be called when vertices were added or hinges removed: the potential's pattern is another one, and
    /// the next call is about positions near x [3, V] m.
    virtual void topology_changed(const ShellChange& change, const Potential& potential,
                                  const Positions& x) = 0;
    /// Moves x [3, V] m towards the minimum by at most so many iterations. x must be where the potential is
    /// finite; no motion leads through a place where it is not.
    virtual MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) = 0;
};

}  // namespace sherd
