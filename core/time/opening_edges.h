// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"

namespace sherd {

/// Edges that open gradually, so that each edge dissipates the energy that its crack requires. When an edge
/// fails, a share of the forces that held it together stays on its vertices as cohesive forces. This share
/// falls while the forces dissipate energy against the opening. The forces never dissipate more than the
/// crack requires and, like friction, never drive a motion.
///
/// In explicit steps, by work: the share is sqrt(1 - W / W_c), where W is the work dissipated and W_c the
/// work to be dissipated; it is zero once the edge's age is twelve times the time of its opening. When an
/// edge fails, the vertices keep their accelerations. Where the forces of a new edge oppose the forces left
/// of an earlier edge, as when an opening that absorbs energy follows an opening that released it, the
/// opposite parts cancel.
///
/// In implicit steps, by time: the share falls linearly to zero in the time of an opening, most often in the
/// step of the failure, which is solved again. In each solution the forces are taken to fall linearly as the
/// crack faces separate, so that they dissipate the mean of their old and new size times the displacement:
/// the crack closure integral (Irwin 1957; over the edges of a mesh Rybicki and Kanninen 1977), exact where
/// forces are linear. Forces end when the edge has dissipated the energy that its crack requires, or when it
/// closes.
class OpeningEdges : public Energy {
  public:
    enum class Fading { by_work, by_time };
    explicit OpeningEdges(Fading fading) : fading(fading) {}

    /// Adds an edge that fails at x, [3, V] m. forces: N, [3, V], that held the edge together; released: J,
    /// stored energy that was lost when the edge failed.
    void open(const Opening& edge, Positions forces, const Positions& x, double released);
    /// Share of the cohesive force of an edge that still acts; 0 for an open edge.
    double cohesive_share(Index edge) const;
    bool empty() const { return all.empty(); }
    /// Adds the present forces to `sum`, N, [3, V].
    void add_forces(Positions& sum) const;

    // For fading by work:

    /// Reduces the forces after a substep of `length` s in which vertices moved by `moved`, [3, V] m.
    void fade(const Positions& moved, double length);

    // For fading by time:

    /// Begins a step at x, [3, V] m. An open step is discarded with the edges that failed in it: no force is
    /// left on them.
    void begin_step(const StepContext& step, const Positions& x);
    /// Must be called before the shell changes; its positions are those of the last solution.
    void shell_changes();
    /// Must be called after a change of the shell. x: its positions, [3, V] m.
    void shell_changed(const Positions& x);
    /// Must be called after each solution of the step. x: its positions, [3, V] m.
    void solved(const Positions& x);
    void finish();
    double taken() const;  ///< J, energy dissipated in the open step

    void topology_changed(const ShellChange& /*change*/, const StepContext& /*step*/) override {}
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions&, Curvature, BlockMatrix&) const override {}
    void visit_state(StateVisitor& visit) override {
        auto& [fading, start, end, all, finished, is_solved, settled] = *this;
        visit(start, end, all, finished, is_solved, settled);
    }

  private:
    struct CohesiveEdge {
        Index edge;
        std::vector<Index> vertices;  ///< ascending
        Positions forces;             ///< N, [3, vertices], forces while the share is 1
        double needed;      ///< J, to be dissipated; by time, what was left at the previous solution
        double lasts;       ///< s, time of the opening
        Positions at;       ///< m, positions of the vertices at the previous solution
        double since;       ///< s, beginning of the step in which it failed
        double age = 0;     ///< s, time since the failure, if forces fade by work
        double before = 1;  ///< share of the forces at the previous solution
        double share = 1;   ///< share of the forces now
        double taken = 0;   ///< J, part of `needed` that has been dissipated
        bool closes = false;

        /// Columns that belong to `vertices`.
        Positions columns_of(const Positions& of_all) const { return of_all(Eigen::all, vertices); }
        /// Work against the forces, J, when vertices move by `moved`, [3, V] m.
        double against(const Positions& moved) const {
            return -forces.cwiseProduct(moved(Eigen::all, vertices)).sum();
        }
        /// Work against the forces, J, since the previous solution, when vertices are at x, [3, V] m.
        double against_until(const Positions& x) const {
            return -forces.cwiseProduct(columns_of(x) - at).sum();
        }
        /// Adds a multiple of the forces to `sum`, [3, V] N.
        void add(double factor, Positions& sum) const;
        /// Cancels the opposite parts of this edge's forces and of `others`, N, [3, V]; the sum of all forces
        /// stays.
        void cancel(Positions& others);
        /// Reduces the share to its value at `end`, the end of a step, s.
        void fade_until(double end);
        void visit_state(StateVisitor& visit) {
            auto& [edge, vertices, forces, needed, lasts, at, since, age, before, share, taken, closes] =
                *this;
            visit(edge, vertices, forces, needed, lasts, at, since, age, before, share, taken, closes);
        }
    };
    /// Adds the energy dissipated since the previous solution to `settled`, and makes the present solution
    /// the previous one.
    void settle();

    Fading fading;
    /// Beginning and end of the open step, s; in statics the end is infinite, so that all forces fade.
    double start = 0, end = 0;
    /// Edges with cohesive forces now, and at the end of the last finished step.
    std::vector<CohesiveEdge> all, finished;
    bool is_solved = false;  ///< whether the step has been solved since the shell changed last
    double settled = 0;      ///< J, dissipated in the open step before the last change
};

}  // namespace sherd
