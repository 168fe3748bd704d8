// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/substep_levels.h"

#include <algorithm>
#include <cmath>

#include "core/shell/rings.h"
#include "core/time/stable_substep.h"

namespace sherd {
namespace {

constexpr int most_levels = 10;
/// Rings of vertices by which the vertices of a level are surrounded: vibrations of the vertices inside fade
/// out towards vertices of lower levels, whose steps are too long for them.
constexpr int rings = 1;
/// Rings around the vertices of a level whose forces change with them.
constexpr int affected_rings = 2;
/// Shares of all vertices that may have levels above 0, as candidates.
constexpr double shares_of_fast[] = {0, 0.001, 0.003, 0.01, 0.02, 0.04};
/// A substep may exceed the stable one by round-off: it is a step divided by a whole number.
constexpr double with_round_off = 1 + 1e-9;
/// Evaluations of forces that cost as much as the rest of a substep.
constexpr double rest_of_substep = 0.5;

/// Surrounds the vertices of each level by rings of vertices of at least this level.
void surround(const Shell& shell, int rings, std::vector<Level>& levels) {
    for (Level level = *std::ranges::max_element(levels); level > 0; --level)
        for (int ring = 0; ring < rings; ++ring) add_ring(shell, level, levels);
}

/// Work of a substep, in evaluations of all forces.
double work_of(const Shell& shell, const std::vector<Level>& levels) {
    std::vector<Level> affected = levels;
    surround(shell, affected_rings, affected);
    double sum = 0;
    for (const Level level : affected) sum += 1 << level;
    return rest_of_substep + sum / static_cast<double>(levels.size());
}

}  // namespace

std::vector<Level> levels_in(const Shell& shell, const VectorXd& stable, double substep, double share) {
    std::vector<Level> levels(stable.size(), 0);
    for (std::size_t v = 0; v < levels.size(); ++v) {
        if (substep <= with_round_off * stable[v]) continue;
        const double ratio = substep / (share * stable[v]);
        levels[v] = static_cast<Level>(std::clamp(std::ceil(std::log2(ratio)), 1.0, double{most_levels + 1}));
    }
    if (std::ranges::any_of(levels, [](Level level) { return level > most_levels; })) return {};
    surround(shell, rings, levels);
    return levels;
}

SubstepLevels substep_levels(const Shell& shell, const VectorXd& stable, double step,
                             const LevelLimits& limits) {
    std::vector<double> sorted(stable.begin(), stable.end());
    std::ranges::sort(sorted);
    SubstepLevels best{substeps_of(step, sorted.front()), {}};
    if (!limits.allowed) return best;
    double least = best.substeps * (1 + rest_of_substep);
    for (const double fast : shares_of_fast) {
        const auto slower = static_cast<std::size_t>(fast * static_cast<double>(sorted.size()));
        const int substeps = substeps_of(step, sorted[slower]);
        if (substeps == best.substeps || step / substeps < limits.shortest) continue;
        std::vector<Level> levels = levels_in(shell, stable, step / substeps, limits.share);
        if (levels.empty()) break;
        const double work = substeps * work_of(shell, levels);
        if (work >= least) continue;
        least = work;
        best = {substeps, std::move(levels)};
    }
    return best;
}

}  // namespace sherd
