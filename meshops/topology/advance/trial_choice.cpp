// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/trial_choice.h"

#include <algorithm>
#include <numbers>

namespace sherd {
namespace {

constexpr double degree = std::numbers::pi / 180;

void improve(Candidate& candidate, double bound) {
    candidate.trial->improve(bound);
    candidate.angle = candidate.trial->smallest_angle();
}

}  // namespace

Candidate plain_candidate(std::unique_ptr<PatchTrial> trial, Vertex vertex, AdvancedEdge::Way way,
                          double distance) {
    const double angle = trial->smallest_angle();
    return {std::move(trial), vertex, way, distance, angle};
}

Candidate chosen(std::vector<Candidate> snaps, std::vector<Candidate> cuts, const AdvanceOptions& options) {
    constexpr std::size_t most_cuts = 4;
    constexpr double round_off = 1e-9;
    const double bound = options.smallest_angle * degree, wanted = options.wanted_angle * degree;
    for (Candidate& snap : snaps)
        if (snap.angle >= options.snap_angle * degree) return std::move(snap);

    std::ranges::stable_sort(cuts, std::greater<>(), &Candidate::angle);
    if (cuts.size() > most_cuts) cuts.resize(most_cuts);
    std::vector<Candidate> all;
    for (auto* some : {&snaps, &cuts}) {
        for (Candidate& candidate : *some) {
            if (candidate.angle < 0) continue;
            if (candidate.way == AdvancedEdge::Way::snapped) candidate.way = AdvancedEdge::Way::relaxed;
            improve(candidate, wanted);
            all.push_back(std::move(candidate));
        }
        const auto best = std::ranges::max_element(all, {}, &Candidate::angle);
        if (best != all.end() && best->angle >= wanted) return std::move(*best);
    }
    std::erase_if(all, [&](const Candidate& candidate) {
        const double least = std::min(bound, candidate.trial->replaced_angle() - round_off);
        return candidate.angle < (options.always_straight ? round_off : least);
    });
    const auto best = std::ranges::max_element(all, {}, &Candidate::angle);
    if (best == all.end()) return {};
    return std::move(*best);
}

}  // namespace sherd
