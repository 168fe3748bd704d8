// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/batches/elastic_gradient.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// Local time steps: elastic forces with which central differences of one substep are stable, although some
/// vertices vibrate faster than this substep could follow.
///
/// Each vertex has a level. A vertex of level k is followed in 2^k parts of the substep, from rest at the
/// substep's beginning, while vertices of lower levels stay: its even motion, the mean of the motions forward
/// and backward in time, in which no velocity occurs. The force is the mean of the forces along this motion
/// (leapfrog with local time steps: Diaz, Grote 2009; levels one within the other: Diaz, Grote 2015). Two
/// parts for one at each level give the recursion
///     F_k(x) = 1/2 F_k+1(x) + 1/2 F_k+1(x + P (1 + nu) h^2 / 2 a),
/// with the length h of a part at level k + 1, the acceleration a by F_k+1(x), and the projection P on
/// vertices of at least level k + 1. Without nu some frequencies would be just at the limit of stability,
/// where any disturbance makes them grow (stabilization: Grote, Michel, Sauter 2021, arXiv 2005.13350).
///
/// Every force in the mean is a sum of element forces, each without net force, so that linear momentum stays.
/// Torques of elements vanish at the moved positions, not at x: forces proportional to mass and to the
/// distance from an axis, the least in the norm of inverse masses, correct that for each group of connected
/// vertices.
class LocalSteps {
  public:
    /// Share by which motions are lengthened: nu in the recursion.
    static constexpr double stabilization = 0.25;
    /// Share of its longest stable step that a vertex with a level above 0 may have as a part: less than 1 /
    /// sqrt(1 + stabilization), since vibrations of a level also move the vertices around it, whose parts are
    /// longer.
    static constexpr double share_of_stable = 0.67;

    /// Shell and gradient must outlive this object.
    LocalSteps(const Shell& shell, ElasticGradient& gradient) : shell(shell), gradient(gradient) {}
    /// Sets the level of each vertex, [V].
    void set_levels(const std::vector<Level>& levels);
    /// Finds the forces, N, [3, V], at x, [3, V] m. length: s, of the substep; others: N, [3, V], all other
    /// forces, weight included.
    void find(const Positions& x, double length, const Positions& others, Positions& elastic);

    /// The forces of the last find() as they would be if all vertices had level 0, N, [3, V]; to be used only
    /// if highest() is not 0.
    const Positions& without_levels() const { return plain; }
    /// Visits the forces; the owner restores the levels.
    void visit_state(StateVisitor& visit) {
        auto& [shell, gradient, highest_level, vertices, groups, has_groups, means, places, plain] = *this;
        visit(plain);
    }
    Level highest() const { return highest_level; }

  private:
    struct Part;
    void average(int level, const Part& part);
    void find_groups();
    void correct_torques(const Positions& x, Positions& elastic) const;

    const Shell& shell;
    ElasticGradient& gradient;
    Level highest_level = 0;
    LevelOrder vertices;
    /// Groups of connected vertices whose forces the local steps change.
    std::vector<std::vector<Index>> groups;
    bool has_groups = false;
    // Buffers for each level, and forces at x, N, [3, V].
    std::vector<Positions> means, places;
    Positions plain;
};

}  // namespace sherd
