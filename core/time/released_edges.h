// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"
#include "core/time/kept_forces.h"

namespace sherd {

/// Edges that open in implicit steps. When an edge fails, the forces that held it together fade to nothing in
/// the time of its opening, most often while the same step is solved again. In each solution they fall as the
/// lips part, so that they take half of what they were and are, times the way: the crack closure integral
/// (Irwin 1957; over the edges of a mesh Rybicki and Kanninen 1977), exact where forces are linear. An edge
/// takes no more than its crack needs, and then nothing holds it any more; nor where it closes.
class ReleasedEdges : public Energy {
  public:
    /// An open step is forgotten, with the edges that failed in it: nothing holds them any more. x: [3, V] m.
    void begin_step(const StepContext& step, const Positions& x);
    /// The shell is about to change, at the last solution.
    void shell_changes();
    /// It has changed, and is at x, [3, V] m.
    void shell_changed(const Positions& x);
    /// An edge has failed at x, [3, V] m. kept: [3, V] N, what held it together; gone: J, that went out of
    /// what is stored at once.
    void open(const Opening& edge, const Positions& kept, const Positions& x, double gone);
    /// The step has been solved, once more.
    void solved(const Positions& x);
    void finish();

    double taken() const;           ///< J, in the open step
    double held(Index edge) const;  ///< share of what held an edge together that still does

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
        Positions at;       ///< m, of its vertices, at the solution before
        double needed;      ///< J, that they still shall take
        double since;       ///< s, begin of the step in which it failed
        double lasts;       ///< s
        double before = 1;  ///< share of the forces at the solution before
        double share = 1;   ///< of them now
        double taken = 0;   ///< J, since the solution before
        bool closes = false;

        /// To what is left at the end of a step, s.
        void fade(double end);
        void visit_state(StateVisitor& visit) {
            auto& [edge, kept, at, needed, since, lasts, before, share, taken, closes] = *this;
            visit(edge, kept, at, needed, since, lasts, before, share, taken, closes);
        }
    };
    /// The way from here on counts anew.
    void settle();

    double start = 0, end = 0;        ///< s, of the open step; in statics all has faded at its end
    std::vector<Kept> all, finished;  ///< now, and at the end of the last finished step
    bool is_solved = false;           ///< since the last change
    double settled = 0;               ///< J, taken in the open step before the last change
};

}  // namespace sherd
