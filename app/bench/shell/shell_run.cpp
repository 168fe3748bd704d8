// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/shell_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/machine/processor_time.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "core/vibration/vibration.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The end of a step: load factor, and displacement of each gauge.
struct Station {
    double load;
    std::vector<Vector3d> gauges;
};

Station station(const StepReport& report) {
    Station one{report.load, {}};
    for (const GaugeReading& reading : report.gauges) one.gauges.push_back(reading.displacement);
    return one;
}

/// Makes steps to the end of the run, or to the first step that cannot be solved. Returns a station for each
/// step, and sets the iterations, the results of ShellCase::measure and the failure of `run`.
std::vector<Station> stations(const ShellCase& one, const Scene& scene, Simulation& simulation,
                              ShellRun& run) {
    std::vector<Station> all;
    StepReport report;
    try {
        while (simulation.time() < scene.duration && !simulation.arrived()) {
            report = simulation.step();
            run.iterations += report.newton_iterations;
            all.push_back(station(report));
        }
        if (one.measure) run.results = one.measure(simulation, report);
    } catch (const Error& error) {
        run.failure = error.what();
    }
    return all;
}

void add_references(const ShellCase& one, const Scene& scene, const std::vector<Station>& path,
                    ShellRun& run) {
    for (const ShellReference& reference : one.references) {
        const auto at = std::ranges::find_if(
            path, [&](const Station& s) { return std::abs(s.load - reference.load) < 1e-9; });
        if (at == path.end()) continue;
        const auto gauge = std::ranges::find(scene.gauges, reference.gauge, &GaugeSpec::name);
        run.results.push_back({fmt::format("{} at {}", reference.name, reference.load),
                               at->gauges[gauge - scene.gauges.begin()][reference.axis], reference.value});
    }
}

/// Returns the load factor at a limit point, and the displacement along x of the first gauge there. The limit
/// point is the extremum of the parabola through station `i` and its two neighbours; at an end of the path it
/// is station `i`.
std::pair<double, double> limit_near(const std::vector<Station>& path, std::size_t i) {
    if (i == 0 || i + 1 >= path.size()) return {path[i].load, path[i].gauges[0].x()};
    const double before = path[i - 1].load, here = path[i].load, after = path[i + 1].load;
    const double bend = before - 2 * here + after;
    const double shift = bend == 0 ? 0 : 0.5 * (before - after) / bend;  // from station i, in steps
    const Vector3d &a = path[i - 1].gauges[0], &b = path[i].gauges[0], &c = path[i + 1].gauges[0];
    return {here - 0.25 * (before - after) * shift,
            b.x() + 0.5 * shift * (c.x() - a.x()) + 0.5 * shift * shift * (a.x() - 2 * b.x() + c.x())};
}

void add_limits(const ShellLimit& limit, const std::vector<Station>& path, ShellRun& run) {
    std::size_t highest = 0;
    while (highest + 1 < path.size() && path[highest + 1].load > path[highest].load) ++highest;
    std::size_t lowest = highest;
    for (std::size_t i = highest; i < path.size(); ++i)
        if (path[i].load < path[lowest].load) lowest = i;
    if (lowest == highest) return;
    const auto [up, at_up] = limit_near(path, highest);
    const auto [down, at_down] = limit_near(path, lowest);
    run.results.push_back({"highest load", up, limit.highest});
    run.results.push_back({"-W there", at_up, limit.at_highest});
    run.results.push_back({"lowest load", down, limit.lowest});
    run.results.push_back({"-W there", at_down, limit.at_lowest});
}

void add_frequencies(const ShellCase& one, const Shell& shell, const ShellEnergyOptions& energies,
                     ShellRun& run) {
    const Vibration found = vibration(shell, energies, static_cast<Index>(one.frequencies.size()));
    for (std::size_t i = 0; i < found.modes.size(); ++i)
        run.results.push_back({fmt::format("f{}", i + 1), found.modes[i].frequency(), one.frequencies[i]});
}

}  // namespace

double ShellRun::largest_error() const {
    double largest = 0;
    for (const ShellResult& result : results) largest = std::max(largest, std::abs(result.error()));
    return largest;
}

ShellRun run_case(const ShellCase& one, const ShellVariant& variant) {
    const double start = processor_seconds();
    const Scene scene = parse_scene(scene_text(one, variant), "bench", {});
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    if (one.add_loads) one.add_loads(built.sheets.mechanics(), built.options);
    Simulation simulation(std::move(built.sheets), built.options);
    ShellRun run;
    run.faces = simulation.shell().mechanics().triangles.size();
    if (one.frequencies.empty()) {
        const std::vector<Station> path = stations(one, scene, simulation, run);
        add_references(one, scene, path, run);
        if (!one.limits.empty() && !path.empty()) add_limits(one.limits.front(), path, run);
    } else {
        add_frequencies(one, simulation.shell().mechanics(), built.options.stepper.shell, run);
    }
    run.seconds = processor_seconds() - start;
    return run;
}

}  // namespace sherd
