// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/measures.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "app/measures/first_contact.h"
#include "meshops/error.h"

namespace sherd {
namespace {

double mass_of(const MeasuredFragment& fragment) {
    return fragment.info.mass;
}

void add_fragments(Measures& measures, const Snapshot& frame) {
    const std::vector<FragmentInfo> fragments = fragments_of(frame);
    const std::vector<FragmentExtent> extents = fragment_extents(frame);
    for (std::size_t i = 0; i < fragments.size(); ++i) {
        if (fragments[i].faces == 0) continue;
        if (fragments[i].mass > measures.over) {
            measures.fragments.push_back({fragments[i], extents[i]});
        } else {
            ++measures.fragments_below;
            measures.mass_below += fragments[i].mass;
        }
    }
    std::ranges::stable_sort(measures.fragments, std::greater(), mass_of);
    if (measures.fragments.empty()) return;
    std::vector<double> masses;
    std::ranges::transform(measures.fragments, std::back_inserter(masses), mass_of);
    measures.mass_law = power_law(masses, measures.over > 0 ? measures.over : masses.back());
}

void add_cracks(Measures& measures, const CrackGraph& cracks, const RestMesh& rest,
                const std::vector<Vector3d>& axes) {
    measures.cracks = crack_extent(cracks, rest);
    measures.tortuosity = tortuosity(cracks, rest);
    measures.directions = crack_directions(cracks, rest, axes);
    measures.has_axis = !axes.empty();
    measures.junctions = crack_junctions(cracks, rest);
}

std::optional<FirstFailure> first_crack(const std::vector<EdgeFailure>& failures,
                                        const std::vector<StepReport>& steps, const Snapshot& frame) {
    if (failures.empty()) return std::nullopt;
    const EdgeFailure& first = *std::ranges::min_element(failures, {}, [](const EdgeFailure& failure) {
        return std::tuple(failure.step, failure.stage, -failure.overload);
    });
    FirstFailure crack{.time = first.time, .stress = first.stress};
    for (const Index vertex : first.vertices)
        crack.position += frame.rest.position.col(frame.original.at(vertex)) / 2;
    const auto step = std::ranges::find(steps, first.step, &StepReport::step);
    if (step != steps.end()) crack.load = step->load;
    if (step != steps.end() && step != steps.begin())
        for (const Reaction& reaction : std::prev(step)->reactions)
            crack.forces.push_back(reaction.force.norm());
    return crack;
}

std::optional<Vector3d> place_of(const CrackCentre& centre, const Recording& recording,
                                 const std::optional<FirstFailure>& first) {
    if (centre.point) return centre.point;
    if (!centre.obstacle.empty()) return first_contact(recording, centre.obstacle);
    if (first) return first->position;
    return std::nullopt;
}

std::vector<PeakForce> peak_forces(const std::vector<RecordedSupport>& supports,
                                   const std::vector<StepReport>& steps) {
    std::vector<PeakForce> peaks;
    for (const RecordedSupport& support : supports) peaks.push_back({support});
    for (const StepReport& step : steps)
        for (std::size_t i = 0; i < peaks.size(); ++i) {
            const double force = step.reactions[i].force.norm();
            peaks[i].history.push_back(force);
            if (force > peaks[i].force) peaks[i].force = force, peaks[i].time = step.time;
        }
    return peaks;
}

}  // namespace

std::optional<double> Measures::energy_per_area() const {
    if (cracks.area == 0) return std::nullopt;
    return lost_to_cracks / cracks.area;
}

Measures measures_of(const Recording& recording, double over, const CrackCentre& centre) {
    const std::size_t frames = recording.frame_count();
    if (frames == 0) throw Error("the recording has no frame yet: there is nothing to measure");
    const RecordingHeader header = recording.header();
    const Snapshot frame = recording.frame(frames - 1);
    const std::vector<StepReport> steps = recording.steps();
    const CrackEvents events = recording.events();
    Measures measures;
    measures.over = over;
    add_fragments(measures, frame);
    const CrackGraph cracks = crack_graph(frame);
    add_cracks(measures, cracks, frame.rest, header.rest_axis);
    if (header.time_unit == "s") measures.tip_speeds = tip_speeds(events, steps, frame, cracks.on_rim);
    measures.energies = energy_extents(steps, recording.has_balance());
    for (const StepReport& step : steps) measures.times.push_back(step.time);
    if (!steps.empty()) measures.lost_to_cracks = steps.back().lost_to_cracks;
    measures.first_crack = first_crack(events.failures, steps, frame);
    if (const auto place = place_of(centre, recording, measures.first_crack))
        measures.about = cracks_about(cracks, frame, *place, centre.radii);
    measures.peak_forces = peak_forces(header.supports, steps);
    return measures;
}

}  // namespace sherd
