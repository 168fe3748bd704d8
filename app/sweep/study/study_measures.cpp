// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/study_measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/messages/nearest_name.h"

namespace sherd {
namespace {

using Number = std::optional<double>;

/// Columns of every table, apart from those of the study.
constexpr std::array<std::string_view, 11> fixed_columns{
    "row",     "seed",       "exit",       "wall_seconds", "cpu_seconds", "message",
    "command", "scene_hash", "files_hash", "program_hash", "recording"};

constexpr std::string_view peak_force = "peak_force.", peak_time = "peak_force_time.";

/// Measure of the heaviest fragment; none without fragments.
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

/// Returns the support or obstacle that a measure names, or "".
std::string support_of(const std::string& measure) {
    for (const std::string_view prefix : {peak_force, peak_time})
        if (measure.starts_with(prefix)) return measure.substr(prefix.size());
    return "";
}

}  // namespace

bool is_study_column(std::string_view name) {
    return std::ranges::find(fixed_columns, name) != fixed_columns.end() ||
           measure_error(std::string(name)).empty();
}

const std::vector<StudyMeasure>& study_measures() {
    using F = const MeasuredFragment&;
    using Law = const PowerLaw&;
    using First = const FirstFailure&;
    using Directions = const CrackDirections&;
    using About = const CracksAbout&;
    using Tips = const TipSpeeds&;
    static const std::vector<StudyMeasure> all{
        {"fragments", "", "number of fragments heavier than `over`",
         [](const Measures& m) { return Number(m.fragments.size()); }},
        {"fragments_below", "", "number of lighter fragments",
         [](const Measures& m) { return Number(m.fragments_below); }},
        {"mass_below", "kg", "total mass of lighter fragments",
         [](const Measures& m) { return Number(m.mass_below); }},
        {"largest.mass", "kg", "mass of the heaviest fragment", of_heaviest([](F f) { return f.info.mass; })},
        {"largest.area", "m^2", "its area at rest", of_heaviest([](F f) { return f.info.area; })},
        {"largest.length", "m", "its length at rest", of_heaviest([](F f) { return f.extent.length; })},
        {"largest.width", "m", "its width at rest", of_heaviest([](F f) { return f.extent.width; })},
        {"largest.aspect_ratio", "", "length over width",
         of_heaviest([](F f) { return f.extent.aspect_ratio(); })},
        {"median_mass", "kg", "median of the fragments' masses", median_mass},
        {"mass_law.exponent", "", "b of N(> m) ~ m^-b", of_law([](Law law) { return law.exponent; })},
        {"mass_law.lower", "", "lower end of its interval", of_law([](Law law) { return law.interval[0]; })},
        {"mass_law.upper", "", "upper end of its interval", of_law([](Law law) { return law.interval[1]; })},
        {"crack_length", "m", "length of edges that failed, at rest",
         [](const Measures& m) { return Number(m.cracks.length); }},
        {"crack_area", "m^2", "area of edges that failed: length times thickness",
         [](const Measures& m) { return Number(m.cracks.area); }},
        {"tortuosity", "", "tortuosity of cracks: path over chord",
         [](const Measures& m) { return m.tortuosity; }},
        {"crack_direction.mean", "deg", "mean direction of cracks against the material's axis",
         of_directions([](Directions d) { return d.mean; })},
        {"crack_direction.resultant", "", "alignment of cracks: 1 all parallel, 0 in all directions",
         of_directions([](Directions d) { return d.resultant; })},
        {"branchings", "", "places where cracks branch or meet",
         [](const Measures& m) { return Number(m.junctions.size()); }},
        {"branching_angle", "deg", "mean of the smallest angles at branchings",
         [](const Measures& m) { return branching_angle(m.junctions); }},
        {"radial_cracks", "", "number of cracks about `about`, median over circles",
         of_centre([](About about) { return about.radial(); })},
        {"ring_cracks", "", "number of cracks about `about`, median over rays",
         of_centre([](About about) { return about.ring(); })},
        {"tip_speed.mean", "m/s", "mean speed of crack tips over time",
         of_tips([](Tips tips) { return tips.mean(); })},
        {"tip_speed.largest", "m/s", "speed of the fastest tip",
         of_tips([](Tips tips) { return tips.fastest().fastest; })},
        {"lost_to_cracks", "J", "energy lost to cracks",
         [](const Measures& m) { return Number(m.lost_to_cracks); }},
        {"energy_per_area", "J/m^2", "energy lost to cracks over crack_area", &Measures::energy_per_area},
        {"first_crack.time", "s", "time at which the first edge failed",
         of_first_crack([](First f) { return f.time; })},
        {"first_crack.load", "", "factor of all loads at this time",
         of_first_crack([](First f) { return f.load; })},
        {"first_crack.x", "m", "x of this edge at rest",
         of_first_crack([](First f) { return f.position.x(); })},
        {"first_crack.y", "m", "y of this edge at rest",
         of_first_crack([](First f) { return f.position.y(); })},
        {"first_crack.z", "m", "z of this edge at rest",
         of_first_crack([](First f) { return f.position.z(); })},
        {"peak_force", "N", "the largest reaction of all supports and obstacles", largest_force},
    };
    return all;
}

std::string measure_error(const std::string& name) {
    std::vector<std::string> names;
    for (const StudyMeasure& measure : study_measures()) names.push_back(measure.name);
    if (!support_of(name).empty() || std::ranges::find(names, name) != names.end()) return "";
    names.insert(names.end(), {"peak_force.NAME", "peak_force_time.NAME"});
    const std::string nearest = nearest_name(name, names);
    return fmt::format("there is no measure '{}'; {}there are: {}", name,
                       nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest),
                       fmt::join(names, ", "));
}

std::string name_in_measures(const std::string& support) {
    constexpr std::string_view obstacle = "obstacle.";
    return support.starts_with(obstacle) ? support.substr(obstacle.size()) : support;
}

std::string support_error(const std::string& measure, const std::set<std::string>& supports) {
    const std::string support = support_of(measure);
    if (support.empty() || supports.contains(support)) return "";
    const std::string nearest = nearest_name(support, std::vector(supports.begin(), supports.end()));
    return fmt::format("{}: the scene has no support or obstacle '{}'; {}there {}", measure, support,
                       nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest),
                       supports.empty() ? "is none" : fmt::format("are: {}", fmt::join(supports, ", ")));
}

std::string measure_unit(const std::string& name) {
    if (name.starts_with(peak_force)) return "N";
    if (name.starts_with(peak_time)) return "s";
    const auto found = std::ranges::find(study_measures(), name, &StudyMeasure::name);
    return found == study_measures().end() ? "" : found->unit;
}

std::map<std::string, double> measure_values(const Measures& measures) {
    std::map<std::string, double> values;
    for (const StudyMeasure& measure : study_measures())
        if (const Number value = measure.value(measures); value && std::isfinite(*value))
            values[measure.name] = *value;
    for (const PeakForce& peak : measures.peak_forces) {
        values[std::string(peak_force) + name_in_measures(peak.support.name)] = peak.force;
        values[std::string(peak_time) + name_in_measures(peak.support.name)] = peak.time;
    }
    return values;
}

}  // namespace sherd
