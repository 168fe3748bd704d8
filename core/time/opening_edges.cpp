// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/opening_edges.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr double longest = 12;  // times the time of an opening; then no cohesive force is left

}  // namespace

void OpeningEdges::Kept::cancel(Positions& others) {
    const double size = share * kept.forces.squaredNorm();
    if (size == 0) return;
    const double opposed =
        std::clamp(-kept.forces.cwiseProduct(kept.of_these(others)).sum() / size, 0.0, 1.0);
    kept.add(opposed * share, others);
    kept.forces *= 1 - opposed;
    needed *= 1 - opposed;
    taken *= 1 - opposed;
}

void OpeningEdges::open(const Opening& edge, Positions kept, double gone) {
    for (Kept& one : all) one.cancel(kept);
    std::erase_if(all, [](const Kept& one) { return one.needed == 0; });
    if (!(edge.energy > gone)) return;
    all.push_back({edge.edge, KeptForces(kept), edge.energy - gone, longest * edge.time});
}

void OpeningEdges::fade(const Positions& moved, double length) {
    for (Kept& one : all) {
        const double against = one.kept.against(moved);
        one.age += length;
        const double reached = one.taken + one.share * std::max(0.0, against);
        const double before = one.share, left = std::sqrt(std::max(0.0, 1 - reached / one.needed));
        // Where the edge closes, the forces left would drive it: they are zero until the edge opens again.
        one.share = against < 0 ? 0 : std::min(left, std::max(0.0, 1 - one.age / one.longest));
        one.taken = left > 0 ? one.taken + std::max(0.0, 0.5 * (before + one.share) * against) : one.needed;
    }
    std::erase_if(all, [](const Kept& one) { return one.taken >= one.needed || one.age >= one.longest; });
}

void OpeningEdges::add_forces(Positions& sum) const {
    for (const Kept& one : all) one.kept.add(one.share, sum);
}

double OpeningEdges::held(Index edge) const {
    const auto found = std::ranges::find(all, edge, &Kept::edge);
    return found == all.end() ? 0 : std::sqrt(1 - found->taken / found->needed);
}

}  // namespace sherd
