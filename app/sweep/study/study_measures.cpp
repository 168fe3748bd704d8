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

/// Columns of every study's table besides parameters, measures and keys of a Python file.
constexpr std::array<std::string_view, 11> fixed_columns{
    "row",     "seed",       "exit",       "wall_seconds", "cpu_seconds", "message",
    "command", "scene_hash", "files_hash", "program_hash", "recording"};

constexpr std::string_view peak_force = "peak_force.", peak_time = "peak_force_time.";

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

std::string measure_error(const std::string& name) {
    std::vector<std::string> names;
    for (const RunMeasure& measure : all_measures()) names.push_back(measure.name);
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
    const auto found = std::ranges::find(all_measures(), name, &RunMeasure::name);
    return found == all_measures().end() ? "" : found->unit;
}

std::map<std::string, double> measure_values(const Measures& measures) {
    std::map<std::string, double> values;
    for (const RunMeasure& measure : all_measures())
        if (const std::optional<double> value = measure.value(measures); value && std::isfinite(*value))
            values[measure.name] = *value;
    for (const PeakForce& peak : measures.peak_forces) {
        values[std::string(peak_force) + name_in_measures(peak.support.name)] = peak.force;
        values[std::string(peak_time) + name_in_measures(peak.support.name)] = peak.time;
    }
    return values;
}

}  // namespace sherd
