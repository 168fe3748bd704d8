// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy.h"
#include "core/shell_change.h"
#include "core/state_visitor.h"

namespace sherd {

/// Edges that open gradually, so that each dissipates the energy that its crack requires. When an edge fails,
/// the forces that held it together stay on its vertices as cohesive forces: a share of them, which fades
/// while they dissipate energy against the opening. They never dissipate more than the edge shall, and, like
/// friction, never drive a motion.
///
/// In explicit steps, by work: the share is sqrt(1 - W / W_c), where W is the work dissipated and W_c all
/// that shall be, and zero after twelve times the time of an opening. The vertices keep their accelerations.
/// Where the forces of a new edge oppose those left of an earlier one, as after an opening that released
/// energy and one that absorbs it, the two cancel.
///
/// In implicit steps, by time: the share falls linearly to zero in the time of an opening, most often while
/// the same step is solved again. In each solution the forces fall linearly as the crack faces separate, so
/// that they dissipate the mean of their old and new size times the displacement: the crack closure integral
/// (Irwin 1957; over the edges of a mesh Rybicki and Kanninen 1977), exact where forces are linear. Forces
/// end when the edge has dissipated what its crack requires, and when it closes.
class OpeningEdges : public Energy {
  public:
    enum class Fading { by_work, by_time };
    explicit OpeningEdges(Fading fading) : fading(fading) {}

    /// Adds an edge that fails at x, [3, V] m. forces: [3, V] N, those that held it together; released: J,
    /// stored energy that was lost at once.
    void open(const Opening& edge, Positions forces, const Positions& x, double released);
    /// Share of the cohesive force of an edge that still acts; 0 for an open edge.
    double cohesive_share(Index edge) const;
    bool empty() const { return all.empty(); }
    /// Adds the present forces to `sum`, N, [3, V].
    void add_forces(Positions& sum) const;

    // By work.

    /// Reduces the forces after a substep of `length` s in which vertices moved by `moved`, [3, V] m.
    void fade(const Positions& moved, double length);

    // By time.

    /// Begins a step at x, [3, V] m. An open step is discarded with the edges that failed in it: no force is
    /// left on them.
    void begin_step(const StepContext& step, const Positions& x);
    /// Must be called before the shell changes, at the last solution.
    void shell_changes();
    /// Must be called when the shell has changed, and is at x, [3, V] m.
    void shell_changed(const Positions& x);
    /// Must be called after each solution of the step.
    void solved(const Positions& x);
    void finish();
    double taken() const;  ///< J, dissipated in the open step

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
        Positions forces;             ///< N, on each of the vertices
        double needed;                ///< J, to be dissipated; by time, since the previous solution
        double lasts;                 ///< s, time of the opening
        Positions at;                 ///< m, positions of its vertices at the previous solution
        double since;                 ///< s, beginning of the step in which it failed
        double age = 0;               ///< s
        double before = 1;            ///< share of the forces at the previous solution
        double share = 1;             ///< share of the forces now
        double taken = 0;             ///< J, dissipated of what is needed
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
        /// Removes the opposite parts of these forces and of `others`, [3, V] N; their sum stays.
        void cancel(Positions& others);
        /// Reduces the share to its value at `end`, the end of a step, s.
        void fade_until(double end);
        void visit_state(StateVisitor& visit) {
            auto& [edge, vertices, forces, needed, lasts, at, since, age, before, share, taken, closes] =
                *this;
            visit(edge, vertices, forces, needed, lasts, at, since, age, before, share, taken, closes);
        }
    };
    /// Books the dissipation since the previous solution; the next starts from the present one.
    void settle();

    Fading fading;
    double start = 0, end = 0;  ///< s, of the open step; in statics infinity, so that all forces have faded
    std::vector<CohesiveEdge> all, finished;  ///< now, and at the end of the last finished step
    bool is_solved = false;                   ///< whether the step has been solved since the last change
    double settled = 0;                       ///< J, dissipated in the open step before the last change
};

}  // namespace sherd
