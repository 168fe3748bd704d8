// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/time/kept_forces.h"

namespace sherd {

/// Edges that open in implicit steps. When an edge fails, the forces that held it together fade to zero in
/// the time of its opening, most often while the same step is solved again. In each solution they fall
/// linearly as the crack faces separate, so that they dissipate the mean of their old and new size times the
/// displacement: the crack closure integral (Irwin 1957; over the edges of a mesh Rybicki and Kanninen 1977),
/// exact where forces are linear. Forces end when the edge has dissipated what its crack requires, and when
/// it closes.
class ReleasedEdges : public Energy {
  public:
    /// Begins a step at x, [3, V] m. An open step is discarded with the edges that failed in it: no force is
    /// left on them.
    void begin_step(const StepContext& step, const Positions& x);
    /// Must be called before the shell changes, at the last solution.
    void shell_changes();
    /// Must be called when the shell has changed, and is at x, [3, V] m.
    void shell_changed(const Positions& x);
    /// Adds an edge that fails at x, [3, V] m. kept: [3, V] N, the forces that held it together; gone: J,
    /// stored energy that was lost at once.
    void open(const Opening& edge, const Positions& kept, const Positions& x, double gone);
    /// Must be called after each solution of the step.
    void solved(const Positions& x);
    void finish();

    double taken() const;           ///< J, dissipated in the open step
    double held(Index edge) const;  ///< share of the cohesive force that still acts

    void topology_changed(const ShellChange& /*change*/, const StepContext& /*step*/) override {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions&, Curvature, BlockMatrix&) const override {}
    void visit_state(StateVisitor& visit) override {
        auto& [start, end, all, finished, is_solved, settled] = *this;
        visit(start, end, all, finished, is_solved, settled);
    }

  private:
    struct Kept {
        Index edge;
        KeptForces kept;
        Positions at;       ///< m, positions of its vertices at the previous solution
        double needed;      ///< J, still to be dissipated
        double since;       ///< s, beginning of the step in which it failed
        double lasts;       ///< s, time of the opening
        double before = 1;  ///< share of the forces at the previous solution
        double share = 1;   ///< share of the forces now
        double taken = 0;   ///< J, dissipated since the previous solution
        bool closes = false;

        /// Reduces the share to its value at `end`, the end of a step, s.
        void fade(double end);
        void visit_state(StateVisitor& visit) {
            auto& [edge, kept, at, needed, since, lasts, before, share, taken, closes] = *this;
            visit(edge, kept, at, needed, since, lasts, before, share, taken, closes);
        }
    };
    /// Books the dissipation since the previous solution; the next starts from the present one.
    void settle();

    double start = 0, end = 0;  ///< s, of the open step; in statics infinity, so that all forces have faded
    std::vector<Kept> all, finished;  ///< now, and at the end of the last finished step
    bool is_solved = false;           ///< whether the step has been solved since the last change
    double settled = 0;               ///< J, dissipated in the open step before the last change
};

}  // namespace sherd
