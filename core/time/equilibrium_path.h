// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/solver/minimiser.h"
#include "core/solver/newton_system.h"
#include "core/state_visitor.h"

namespace sherd {

/// The path of equilibria of a shell under a load factor that is unknown itself, so that the path continues
/// past limit points, where the load falls (arc length: Riks 1979, Crisfield 1981). Each step ends at an
/// equilibrium at a given distance from its beginning: the root mean square of the displacement, weighted
/// with masses, divided by the root mean square that a load factor of 1 would cause with the stiffness at the
/// beginning of the path. There, distances along the path are therefore load factors. Equilibria need not be
/// stable.
class EquilibriumPath {
  public:
    /// The shell must outlive this object. tolerance: m, see Newton. last_load: the load factor at which the
    /// path ends.
    EquilibriumPath(const Shell& shell, double tolerance, double last_load)
        : shell(shell), tolerance(tolerance), last_load(last_load) {}

    /// Starts a step of this length, a distance along the path, from the shell's positions, with the load
    /// factor at the end of the last step.
    void begin(double length, StepContext& step);
    /// Advances x [3, V] m and step.load towards the step's equilibrium. loads: the energies that depend on
    /// step.load.
    MinimiserResult solve(Potential& potential, std::span<Energy* const> loads, StepContext& step,
                          int max_iterations, Positions& x);
    /// Must be called when the shell has changed; the open step continues.
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x);
    /// Ends the step at x.
    void finish(const StepContext& step, const Positions& x);

    bool arrived() const { return start_load == last_load; }
    void visit_state(StateVisitor& visit) {
        auto& [shell, tolerance, last_load, system, start_load, length, scale, predicted, at_last_load,
               direction] = *this;
        visit(system, start_load, length, scale, predicted, at_last_load, direction);
    }

  private:
    /// A change of positions and load that Newton's method proposes.
    struct Correction {
        Positions motion;
        double load = 0;
    };

    double distance(const Positions& displacement) const;
    double product(const Positions& a, const Positions& b) const;
    /// Tangent of the path at x: the displacement for each unit of the load factor, m, [3, V].
    Positions tangent(Potential& potential, std::span<Energy* const> loads, StepContext& step,
                      const Positions& x);
    void predict(Potential& potential, std::span<Energy* const> loads, StepContext& step, Positions& x);
    /// Finds the correction with which x has the step's distance from its beginning. moved: displacement
    /// since the beginning; to_equilibrium: correction at a constant load, both m, [3, V]. Returns false if
    /// there is no such correction.
    bool correct(const Positions& moved, const Positions& to_equilibrium, const Positions& tangent,
                 Correction& correction) const;
    /// If the step has passed the last load, moves x back to this load and returns true.
    bool passed(StepContext& step, std::span<Energy* const> loads, Positions& x);

    const Shell& shell;
    double tolerance, last_load;
    NewtonSystem system{indefinite_solver()};
    double start_load = 0;
    double length = 0;       ///< distance along the path in the open step
    double scale = 0;        ///< m, root mean square displacement for a length of 1; 0 before the first step
    bool predicted = false;  ///< whether predict() has been called in the open step
    bool at_last_load = false;
    Positions direction;  ///< [3, V] m, displacement of the last step; empty before the first
};

}  // namespace sherd
