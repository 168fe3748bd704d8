// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/measures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <string>
#include <tuple>

#include "app/playback/playback.h"
#include "app/recording/recording.h"
#include "meshops/error.h"
#include "meshops/intersect/nearest_triangle.h"

namespace sherd {
namespace {

std::size_t number_of(const std::vector<RecordedObstacle>& obstacles, const std::string& name) {
    const auto found = std::ranges::find(obstacles, name, &RecordedObstacle::name);
    if (found != obstacles.end()) return found - obstacles.begin();
    std::vector<std::string> names;
    for (const RecordedObstacle& obstacle : obstacles) names.push_back(obstacle.name);
    throw Error(fmt::format("--about {}: the recording has no such obstacle; it has {}", name,
                            names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

/// Returns the end of the first step in which the obstacle had a contact force, s. Forces on free bodies are
/// not recorded: for a free body returns the end of the first step with any contact. Throws Error (input) if
/// there is no such step.
double first_touch(const Recording& recording, const std::string& name) {
    const std::vector<RecordedSupport> supports = recording.header().supports;
    const auto support = std::ranges::find(supports, "obstacle." + name, &RecordedSupport::name);
    for (const StepReport& step : recording.steps())
        if (support == supports.end() ? step.contacts > 0
                                      : !step.reactions[support - supports.begin()].force.isZero(0))
            return step.time;
    throw Error(fmt::format("--about {}: the obstacle has touched nothing", name));
}

PlaybackTime moment_at(const Recording& recording, double time) {
    PlaybackTime moment{.time = time};
    while (moment.later + 1 < recording.frame_count() && recording.time(moment.later) < time) ++moment.later;
    const double late = recording.time(moment.later);
    if (late <= time) return {moment.later, moment.later, 0, time};
    if (moment.later == 0) return {0, 0, 0, time};
    moment.earlier = moment.later - 1;
    const double early = recording.time(moment.earlier);
    moment.share = (time - early) / (late - early);
    return moment;
}

NearestTriangle surface_at(const Recording& recording, const std::vector<RecordedObstacle>& obstacles,
                           std::size_t number, const PlaybackTime& moment) {
    const ObstaclePlayback playback(recording);
    const Eigen::Isometry3d pose =
        obstacles[number].deforms ? Eigen::Isometry3d::Identity() : playback.at(moment)[number];
    const GridSurface surface = reshaped(obstacles[number].surface, playback.shapes(moment)[number]);
    Positions points(3, static_cast<Eigen::Index>(surface.points.size()));
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = pose * surface.points[i];
    return {points, surface.triangles};
}

/// Returns the place on the sheets at rest (m) that an obstacle touched first: the vertex that is nearest to
/// the obstacle at the time first_touch(), with positions interpolated between frames. name: "ball" or
/// "obstacle.ball". Throws Error (input) if there is no such obstacle, or if it touched nothing.
Vector3d first_contact(const Recording& recording, const std::string& name) {
    const std::string prefix = "obstacle.";
    const std::string obstacle = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    const std::size_t number = number_of(obstacles, obstacle);
    const PlaybackTime moment = moment_at(recording, first_touch(recording, obstacle));
    const NearestTriangle surface = surface_at(recording, obstacles, number, moment);
    const Snapshot frame = Playback([&](std::size_t number) { return recording.frame(number); }).at(moment);
    double least = std::numeric_limits<double>::infinity();
    Index nearest = 0;
    for (Index v = 0; v < frame.position.cols(); ++v)
        if (const double distance = surface(frame.position.col(v)).distance; distance < least)
            least = distance, nearest = frame.original[v];
    return frame.rest.position.col(nearest);
}

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

using Number = std::optional<double>;

/// Returns a measure that applies `value` to the heaviest fragment; none without fragments. The next
/// functions do the same for other parts of the measures.
template <class Value>
auto of_heaviest(Value value) {
    return [value](const Measures& measures) {
        return measures.fragments.empty() ? Number() : Number(value(measures.fragments.front()));
    };
}

template <class Value>
auto of_law(Value value) {
    return [value](const Measures& measures) {
        return measures.mass_law ? Number(value(*measures.mass_law)) : Number();
    };
}

template <class Value>
auto of_first_crack(Value value) {
    return [value](const Measures& measures) {
        return measures.first_crack ? Number(value(*measures.first_crack)) : Number();
    };
}

template <class Value>
auto of_directions(Value value) {
    return [value](const Measures& measures) {
        return measures.directions.length > 0 ? Number(value(measures.directions)) : Number();
    };
}

template <class Value>
auto of_centre(Value value) {
    return [value](const Measures& measures) {
        return measures.about ? Number(value(*measures.about)) : Number();
    };
}

template <class Value>
auto of_tips(Value value) {
    return [value](const Measures& measures) {
        return measures.tip_speeds ? Number(value(*measures.tip_speeds)) : Number();
    };
}

Number median_mass(const Measures& measures) {
    const auto& fragments = measures.fragments;  // sorted by mass
    if (fragments.empty()) return std::nullopt;
    const std::size_t half = fragments.size() / 2;
    const double upper = fragments[half].info.mass;
    return fragments.size() % 2 == 1 ? upper : (upper + fragments[half - 1].info.mass) / 2;
}

Number largest_force(const Measures& measures) {
    if (measures.peak_forces.empty()) return std::nullopt;
    return std::ranges::max(measures.peak_forces, {}, &PeakForce::force).force;
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

const std::vector<RunMeasure>& all_measures() {
    using F = const MeasuredFragment&;
    using Law = const PowerLaw&;
    using First = const FirstFailure&;
    using Directions = const CrackDirections&;
    using About = const CracksAbout&;
    using Tips = const TipSpeeds&;
    constexpr bool grouped = true;
    static const std::vector<RunMeasure> all{
        {"fragments", "", "number of fragments heavier than `over`",
         [](const Measures& m) { return Number(m.fragments.size()); }, grouped},
        {"fragments_below", "", "number of lighter fragments",
         [](const Measures& m) { return Number(m.fragments_below); }, grouped},
        {"mass_below", "kg", "total mass of lighter fragments",
         [](const Measures& m) { return Number(m.mass_below); }, grouped},
        {"largest.mass", "kg", "mass of the heaviest fragment", of_heaviest([](F f) { return f.info.mass; }),
         grouped},
        {"largest.area", "m^2", "its area at rest", of_heaviest([](F f) { return f.info.area; }), grouped},
        {"largest.length", "m", "its length at rest", of_heaviest([](F f) { return f.extent.length; }),
         grouped},
        {"largest.width", "m", "its width at rest", of_heaviest([](F f) { return f.extent.width; }), grouped},
        {"largest.aspect_ratio", "", "length over width",
         of_heaviest([](F f) { return f.extent.aspect_ratio(); }), grouped},
        {"median_mass", "kg", "median of the fragments' masses", median_mass},
        {"mass_law.exponent", "", "b of N(> m) ~ m^-b", of_law([](Law law) { return law.exponent; }),
         grouped},
        {"mass_law.lower", "", "lower end of its interval", of_law([](Law law) { return law.interval[0]; }),
         grouped},
        {"mass_law.upper", "", "upper end of its interval", of_law([](Law law) { return law.interval[1]; }),
         grouped},
        {"crack_length", "m", "length of edges that failed, at rest",
         [](const Measures& m) { return Number(m.cracks.length); }, grouped},
        {"crack_area", "m^2", "area of edges that failed: length times thickness",
         [](const Measures& m) { return Number(m.cracks.area); }, grouped},
        {"tortuosity", "", "tortuosity of cracks: path over chord",
         [](const Measures& m) { return m.tortuosity; }, grouped},
        {"crack_direction.mean", "deg", "mean direction of cracks against the material's axis",
         of_directions([](Directions d) { return d.mean; }), grouped},
        {"crack_direction.resultant", "", "alignment of cracks: 1 all parallel, 0 in all directions",
         of_directions([](Directions d) { return d.resultant; }), grouped},
        {"branchings", "", "places where cracks branch or meet",
         [](const Measures& m) { return Number(m.junctions.size()); }, grouped},
        {"branching_angle", "deg", "mean of the smallest angles at branchings",
         [](const Measures& m) { return branching_angle(m.junctions); }, grouped},
        {"radial_cracks", "", "number of cracks about `about`, median over circles",
         of_centre([](About about) { return about.radial(); }), grouped},
        {"ring_cracks", "", "number of cracks about `about`, median over rays",
         of_centre([](About about) { return about.ring(); }), grouped},
        {"tip_speed.mean", "m/s", "mean speed of crack tips over time",
         of_tips([](Tips tips) { return tips.mean(); }), grouped},
        {"tip_speed.largest", "m/s", "speed of the fastest tip",
         of_tips([](Tips tips) { return tips.fastest().fastest; }), grouped},
        {"lost_to_cracks", "J", "energy lost to cracks",
         [](const Measures& m) { return Number(m.lost_to_cracks); }, grouped},
        {"energy_per_area", "J/m^2", "energy lost to cracks over crack_area", &Measures::energy_per_area,
         grouped},
        {"first_crack.time", "s", "time at which the first edge failed",
         of_first_crack([](First f) { return f.time; }), grouped},
        {"first_crack.load", "", "factor of all loads at this time",
         of_first_crack([](First f) { return f.load; }), grouped},
        {"first_crack.x", "m", "x of this edge at rest",
         of_first_crack([](First f) { return f.position.x(); }), grouped},
        {"first_crack.y", "m", "y of this edge at rest",
         of_first_crack([](First f) { return f.position.y(); }), grouped},
        {"first_crack.z", "m", "z of this edge at rest",
         of_first_crack([](First f) { return f.position.z(); }), grouped},
        {"peak_force", "N", "the largest reaction of all supports and obstacles", largest_force, grouped},
    };
    return all;
}

}  // namespace sherd
