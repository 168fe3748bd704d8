// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/tip_speeds.h"

#include <algorithm>
#include <map>
#include <set>

#include "meshops/disjoint_sets.h"

namespace sherd {
namespace {

/// An edge that failed; its vertices and length are at rest.
struct NewCrack {
    std::array<Index, 2> ends{};
    double length = 0;  ///< m
};

NewCrack at_rest(const EdgeFailure& failure, const Snapshot& frame) {
    const Index a = frame.original.at(failure.vertices[0]), b = frame.original.at(failure.vertices[1]);
    return {{a, b}, (frame.rest.position.col(a) - frame.rest.position.col(b)).norm()};
}

/// A connected set of edges that failed in the same step.
struct Growth {
    double length = 0;  ///< m
    std::size_t tips = 0;
};

/// Returns the connected sets of `cracks`, which failed in one step. old: vertices of earlier cracks and of
/// rims, where no tips are.
std::vector<Growth> growths(const std::vector<NewCrack>& cracks, const std::set<Index>& old) {
    std::map<Index, std::vector<std::size_t>> at;
    DisjointSets together(cracks.size());
    for (std::size_t i = 0; i < cracks.size(); ++i)
        for (const Index end : cracks[i].ends) {
            at[end].push_back(i);
            together.join(i, at[end].front());
        }
    std::map<std::size_t, Growth> by_set;
    for (std::size_t i = 0; i < cracks.size(); ++i) by_set[together.find(i)].length += cracks[i].length;
    for (const auto& [vertex, incident] : at)
        if (incident.size() == 1 && !old.contains(vertex)) ++by_set[together.find(incident.front())].tips;
    std::vector<Growth> all;
    for (const auto& [set, growth] : by_set)
        all.push_back({growth.length, std::max<std::size_t>(growth.tips, 1)});
    return all;
}

void add_growth(TipStep& step, const Growth& growth) {
    step.tips += growth.tips;
    const double speed = growth.length / (static_cast<double>(growth.tips) * step.step_size);
    step.speed += growth.length / step.step_size;  // sum over tips; tip_speeds() divides by their number
    step.fastest = std::max(step.fastest, speed);
}

/// Replaces the tips and speeds that follow from the lengths of failed edges by the recorded ones.
void take_records(std::map<std::int64_t, TipStep>& steps, const std::vector<TipRecord>& records) {
    for (auto& [number, step] : steps) step.tips = 0, step.speed = step.fastest = 0;
    for (const TipRecord& record : records) {
        const auto step = steps.find(record.step);
        if (step == steps.end() || !(record.speed > 0)) continue;
        ++step->second.tips;
        step->second.speed += record.speed;
        step->second.fastest = std::max(step->second.fastest, record.speed);
    }
}

}  // namespace

double TipSpeeds::mean() const {
    double way = 0, time = 0;
    for (const TipStep& step : steps) {
        const double together = static_cast<double>(step.tips) * step.step_size;
        way += step.speed * together;
        time += together;
    }
    return time > 0 ? way / time : 0;
}

TipStep TipSpeeds::fastest() const {
    return steps.empty() ? TipStep{} : *std::ranges::max_element(steps, {}, &TipStep::fastest);
}

TipSpeeds tip_speeds(const CrackEvents& events, const std::vector<StepReport>& steps, const Snapshot& frame,
                     const std::vector<char>& on_rim) {
    std::map<std::int64_t, TipStep> by_number;
    for (const StepReport& step : steps)
        by_number[step.step] = {.time = step.time, .step_size = step.step_size};
    std::set<Index> old;
    for (std::size_t v = 0; v < on_rim.size(); ++v)
        if (on_rim[v] != 0) old.insert(static_cast<Index>(v));
    std::map<std::int64_t, std::vector<NewCrack>> cracks;
    for (const EdgeFailure& failure : events.failures)
        cracks[failure.step].push_back(at_rest(failure, frame));
    for (const auto& [number, together] : cracks) {
        if (const auto step = by_number.find(number); step != by_number.end() && step->second.step_size > 0)
            for (const Growth& growth : growths(together, old)) {
                step->second.length += growth.length;
                add_growth(step->second, growth);
            }
        for (const NewCrack& crack : together) old.insert(crack.ends.begin(), crack.ends.end());
    }
    TipSpeeds speeds{.steps = {}, .recorded = !events.tips.empty()};
    if (speeds.recorded) take_records(by_number, events.tips);
    for (auto& [number, step] : by_number) {
        if (step.tips == 0) continue;
        step.speed /= static_cast<double>(step.tips);
        speeds.steps.push_back(step);
    }
    return speeds;
}

}  // namespace sherd
