// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/batches/elastic_gradient.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// Local time steps: elastic forces with which central differences of one substep are stable, although some
/// vertices vibrate faster than this substep could follow.
///
/// Each vertex has a level. A vertex of level k is followed in 2^k short steps, from rest at the substep's
/// beginning, while vertices of lower levels stay: its even motion, the mean of the motions forward and
/// backward in time, in which no velocity occurs. The force is the mean of the forces along this motion
/// (leapfrog with local time steps: Diaz, Grote 2009; levels one within the other: Diaz, Grote 2015). Two
/// short steps for one at each level give the recursion
///     F_k(x) = 1/2 F_k+1(x) + 1/2 F_k+1(x + P (1 + nu) h^2 / 2 a),
/// with the length h of a short step at level k + 1, the acceleration a by F_k+1(x) and all other forces, and
/// the projection P on vertices of at least level k + 1. Without nu some frequencies would be just at the
/// limit of stability, where any disturbance makes them grow (stabilization: Grote, Michel, Sauter 2021,
/// arXiv 2005.13350).
///
/// Every force in the mean is a sum of element forces, each without net force, so that linear momentum stays.
/// Torques of elements vanish at the moved positions, not at x: forces proportional to mass and to the
/// distance from an axis, the least in the norm of inverse masses, correct that for each group of connected
/// vertices.
class LocalSteps {
  public:
    /// Share by which motions are lengthened: nu in the recursion.
    static constexpr double stabilization = 0.25;
    /// Share of the longest stable step of a vertex with a level above 0 that its short steps may have: less
    /// than 1 / sqrt(1 + stabilization), since its vibrations also move the vertices around, whose short
    /// steps are longer.
    static constexpr double share_of_stable = 0.67;

    /// Shell and gradient must outlive this object.
    LocalSteps(const Shell& shell, ElasticGradient& gradient) : shell(shell), gradient(gradient) {}
    /// Sets the level of each vertex, [V]; an empty list stands for level 0 of all. Returns whether levels
    /// have changed.
    bool set_levels(std::vector<Level> levels);
    /// Levels of the vertices, [V], as they were set.
    const std::vector<Level>& levels() const { return of_vertices; }
    Level highest() const { return vertices.highest(); }
    /// Finds the forces, N, [3, V], at x, [3, V] m. length: s, of the substep; others: N, [3, V], all other
    /// forces, weight included; used only if highest() is not 0.
    void find(const Positions& x, double length, const Positions& others, Positions& elastic);

    /// The forces of the last find() as they would be if all vertices had level 0, N, [3, V]; to be used only
    /// if highest() is not 0.
    const Positions& without_levels() const { return plain; }
    void visit_state(StateVisitor& visit) {
        auto& [shell, gradient, of_vertices, vertices, groups, means, places, plain] = *this;
        visit(of_vertices, plain);
        if (!visit.reads()) return;
        gradient.shell_changed();
        restore();
    }

  private:
    struct Search;
    void restore();  ///< sets all that follows from the levels
    void average(int level, const Search& search);
    void find_groups();
    void correct_torques(const Positions& x, Positions& elastic) const;

    const Shell& shell;
    ElasticGradient& gradient;
    std::vector<Level> of_vertices;
    LevelOrder vertices;
    /// Groups of connected vertices whose forces the local steps change; none: not found yet.
    std::optional<std::vector<std::vector<Index>>> groups;
    std::vector<Positions> means, places;  ///< buffers for each level
    Positions plain;                       ///< without_levels()
};

}  // namespace sherd
