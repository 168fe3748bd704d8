// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/released_edges.h"

#include <algorithm>

namespace sherd {

void ReleasedEdges::Kept::fade(double end) {
    share = end - since < lasts ? 1 - (end - since) / lasts : 0;
}

void ReleasedEdges::begin_step(const StepContext& step, const Positions& x) {
    start = step.begin;
    end = step.inertia > 0 ? step.end() : std::numeric_limits<double>::infinity();
    all = finished;
    is_solved = false;
    settled = 0;
    for (Kept& one : all) {
        one.at = one.kept.of_these(x);
        one.fade(end);
    }
}

void ReleasedEdges::settle() {
    settled = taken();
    for (Kept& one : all) {
        one.needed -= one.taken;
        one.taken = 0;
        one.before = one.share;
    }
}

void ReleasedEdges::shell_changes() {
    if (is_solved) settle();
    is_solved = false;
}

void ReleasedEdges::shell_changed(const Positions& x) {
    for (Kept& one : all) one.at = one.kept.of_these(x);
}

void ReleasedEdges::open(const Opening& edge, const Positions& kept, const Positions& x, double gone) {
    if (!(edge.energy > gone)) return;
    const KeptForces forces(kept);
    all.push_back({edge.edge, forces, forces.of_these(x), edge.energy - gone, start, edge.time});
    all.back().fade(end);
}

void ReleasedEdges::solved(const Positions& x) {
    is_solved = true;
    for (Kept& one : all) {
        const double against = one.kept.against_from(one.at, x);
        one.taken = std::clamp(0.5 * (one.before + one.share) * against, 0.0, one.needed);
        one.closes = against < 0;
    }
}

void ReleasedEdges::finish() {
    settle();
    std::erase_if(all, [](const Kept& one) { return one.share == 0 || one.needed <= 0 || one.closes; });
    finished = all;
}

double ReleasedEdges::taken() const {
    double sum = settled;
    for (const Kept& one : all) sum += one.taken;
    return sum;
}

double ReleasedEdges::held(Index edge) const {
    const auto found = std::ranges::find(all, edge, &Kept::edge);
    return found == all.end() ? 0 : found->share;
}

double ReleasedEdges::value(const Positions& x) const {
    double sum = 0;
    for (const Kept& one : all) sum += one.share * one.kept.against_from(one.at, x);
    return sum;
}

void ReleasedEdges::add_gradient(const Positions&, Positions& gradient) const {
    for (const Kept& one : all) one.kept.add(-one.share, gradient);
}

}  // namespace sherd
