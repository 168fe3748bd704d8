// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/substep_levels.h"

#include <algorithm>
#include <cmath>

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
constexpr double shares[] = {0, 0.001, 0.003, 0.01, 0.02, 0.04};
/// Work with levels above 0, over the work without, from which levels are worth their disturbance.
constexpr double most_work_of_levels = 0.6;
/// Share of its work that the last number of substeps counts for: changes of the substep, and so of the
/// effective forces of local steps, excite vibrations.
constexpr double advantage_of_last = 0.7;
/// A substep may exceed the stable one by round-off: it is a step divided by a whole number.
constexpr double with_round_off = 1 + 1e-9;
/// Evaluations of forces that cost as much as the rest of a substep.
constexpr double rest_of_substep = 0.5;

/// Raises all vertices of the faces around vertices of at least `level` to it.
void grow(const Shell& shell, Level level, std::vector<Level>& levels) {
    std::vector<char> inside(levels.size());
    for (std::size_t v = 0; v < levels.size(); ++v) inside[v] = levels[v] >= level;
    for (const TriangleStencil& triangle : shell.triangles) {
        const auto& vertices = triangle.vertices;
        if (std::ranges::none_of(vertices, [&](Index v) { return inside[v] != 0; })) continue;
        for (const Index v : vertices) levels[v] = std::max(levels[v], level);
    }
}

/// Work of a substep, in evaluations of all forces.
double work_of(const Shell& shell, const std::vector<Level>& levels) {
    std::vector<Level> affected = levels;
    const Level highest = *std::ranges::max_element(levels);
    for (Level level = highest; level > 0; --level)
        for (int ring = 0; ring < affected_rings; ++ring) grow(shell, level, affected);
    double sum = 0;
    for (const Level level : affected) sum += 1 << level;
    return rest_of_substep + sum / static_cast<double>(levels.size());
}

}  // namespace

std::vector<Level> levels_in(const Shell& shell, const VectorXd& stable, double substep, double factor) {
    std::vector<Level> levels(stable.size(), 0);
    for (std::size_t v = 0; v < levels.size(); ++v) {
        if (substep <= with_round_off * stable[v]) continue;
        const double ratio = substep / (factor * stable[v]);
        levels[v] = static_cast<Level>(std::clamp(std::ceil(std::log2(ratio)), 1.0, double{most_levels + 1}));
    }
    if (std::ranges::any_of(levels, [](Level level) { return level > most_levels; })) return {};
    const Level highest = *std::ranges::max_element(levels);
    for (Level level = highest; level > 0; --level)
        for (int ring = 0; ring < rings; ++ring) grow(shell, level, levels);
    return levels;
}

SubstepLevels substep_levels(const Shell& shell, const VectorXd& stable, double step,
                             const LevelLimits& limits) {
    std::vector<double> sorted(stable.begin(), stable.end());
    std::ranges::sort(sorted);
    SubstepLevels best{substeps_of(step, sorted.front()), std::vector<Level>(sorted.size(), 0)};
    if (!limits.any) return best;
    double least = most_work_of_levels * best.substeps * (1 + rest_of_substep);
    const auto try_substeps = [&](int substeps, double advantage) {
        if (substeps == best.substeps || step / substeps < limits.shortest) return;
        std::vector<Level> levels = levels_in(shell, stable, step / substeps, limits.factor);
        if (levels.empty()) return;
        const double work = advantage * substeps * work_of(shell, levels);
        if (work >= least) return;
        least = work;
        best = {substeps, std::move(levels)};
    };
    if (limits.last > 0) try_substeps(limits.last, advantage_of_last);
    for (const double share : shares)
        try_substeps(
            substeps_of(step, sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))]),
            1);
    return best;
}

}  // namespace sherd
