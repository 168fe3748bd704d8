// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/cracking_tables.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <map>

#include "app/bench/cost/newton_cost.h"
#include "app/bench/cost/race.h"
#include "app/bench/cost/solver_choice.h"
#include "app/bench/cost/table_head.h"
#include "app/chart/chart_page.h"
#include "app/messages/print.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd {
namespace {

constexpr int settling = 1;  // the first step makes patterns and first factors, and is not measured

/// A mesh and a duration for the scene plate_drop.
struct Drop {
    double edge;  ///< m, length of the mesh's edges
    double end;   ///< s, duration
};

Scene drop_scene(const Drop& drop, const SolverChoice& choice) {
    std::vector<std::string> settings = choice.settings;
    settings.push_back(fmt::format("sheet.plate.mesh.edge_length={}", drop.edge));
    return read_scene(shipped_scene("plate_drop", shipped_scenes(shipped_scene_folder())).file,
                      {settings, ""});
}

/// Cost of the steps of one kind in a run: before the impact, later without failures, or with failures.
struct Steps {
    StepCost cost;
    int laps = 0;

    double in_lap(std::int64_t StepCost::*number) const { return static_cast<double>(cost.*number) / laps; }
    double seconds() const { return cost.seconds / laps; }
};

/// Result of a solver choice in a drop.
struct Broken {
    RaceResult race;
    double factorization;  ///< s, to factorize the unfractured plate's matrix of the same energies once
    Steps flight, quiet, cracking;

    /// Mean time of a cracking step over the mean time of `steps`, which are of another kind.
    double ratio_to(const Steps& steps) const { return cracking.seconds() / steps.seconds(); }
};

std::vector<Broken> broken_plates(const Drop& drop, const std::vector<SolverChoice>& choices) {
    std::map<std::string, double> factorizations;
    std::vector<Scene> scenes;
    for (const SolverChoice& choice : choices) {
        scenes.push_back(drop_scene(drop, choice));
        if (!factorizations.contains(choice.energies))
            factorizations[choice.energies] = newton_cost(scenes.back()).factorization;
    }
    const double step = scenes.front().simulation.stepper.step;
    std::vector<Broken> plates;
    for (RaceResult& raced : race(scenes, {.step = step,
                                          .settling = settling,
                                          .laps = static_cast<int>(drop.end / step + 0.5) - settling,
                                          .allowance = std::numeric_limits<double>::infinity()})) {
        Broken plate{std::move(raced), factorizations[choices[plates.size()].energies], {}, {}, {}};
        bool touched = false;
        for (const StepCost& lap : plate.race.laps) {
            touched |= lap.contacts > 0;
            Steps& steps = lap.stages > 0 ? plate.cracking : touched ? plate.quiet : plate.flight;
            steps.cost += lap;
            ++steps.laps;
        }
        plates.push_back(std::move(plate));
    }
    return plates;
}

void print_head() {
    print_result(
        "\n**plate_drop**: steps before it touches the floor, later ones in which nothing fails, and those "
        "in which something does; processor time, ms, and one factorization of the whole plate's matrix\n\n"
        "{}",
        table_head({"edges (mm)", "faces", "choice", "flight", "quiet steps", "ms", "iterations",
                    "factorizations", "cracking steps", "ms", "iterations", "factorizations", "analyses",
                    "times a quiet one", "times one in flight", "one factorization", "quiet step over it"}));
    std::fflush(stdout);
}

void print_plate(const Drop& drop, const SolverChoice& choice, const Broken& plate) {
    const auto& [quiet, cracking] = std::tie(plate.quiet, plate.cracking);
    print_result("| {:g} | {} | {} | {:.4g} | {} | {:.4g} | {:.1f} | {:.1f} | ", 1e3 * drop.edge,
                 plate.race.faces, choice.name, 1e3 * plate.flight.seconds(), quiet.laps,
                 1e3 * quiet.seconds(), quiet.in_lap(&StepCost::iterations),
                 quiet.in_lap(&StepCost::factorizations));
    print_result("{} | {:.4g} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.3g} | {:.2f} |{}\n",
                 cracking.laps, 1e3 * cracking.seconds(), cracking.in_lap(&StepCost::iterations),
                 cracking.in_lap(&StepCost::factorizations), cracking.in_lap(&StepCost::analyses),
                 plate.ratio_to(quiet), plate.ratio_to(plate.flight), 1e3 * plate.factorization,
                 quiet.seconds() / plate.factorization,
                 plate.race.failure.empty() ? "" : " " + plate.race.failure);
    std::fflush(stdout);
}

Json steps_json(const Steps& steps) {
    return {{"steps", steps.laps},
            {"seconds", steps.cost.seconds},
            {"iterations", steps.cost.iterations},
            {"factorizations", steps.cost.factorizations},
            {"analyses", steps.cost.analyses},
            {"stages", steps.cost.stages},
            {"halvings", steps.cost.halvings}};
}

Chart time_chart(const Drop& drop, const std::vector<SolverChoice>& choices,
                 const std::vector<Broken>& plates) {
    Chart chart{fmt::format("Steps of plate_drop, edges of {:g} mm", 1e3 * drop.edge),
                {.name = "time", .unit = "s"},
                {.name = "processor time", .unit = "s", .logarithmic = true},
                {}};
    for (std::size_t i = 0; i < plates.size(); ++i) {
        ChartSeries series{.name = choices[i].name,
                           .colour = choices[i].colour,
                           .points = {},
                           .stepped = true,
                           .dashed = choices[i].dashed};
        double time = settling * plates[i].race.laps.front().simulated;
        for (const StepCost& lap : plates[i].race.laps) {
            series.points.emplace_back(time, lap.seconds);
            time += lap.simulated;
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace

std::pair<Json, std::string> cracking(const std::string& only, bool quick, bool print) {
    const std::vector<SolverChoice> choices = exact_choices(only);
    const std::vector<Drop> drops =
        quick ? std::vector<Drop>{{0.007, 3e-3}} : std::vector<Drop>{{0.007, 5e-3}, {0.0035, 5e-3}};
    ChartPage page{
        .heading = "What a step costs", .columns = drops.size(), .panel_height = 360, .shares_legend = true};
    Json json = Json::array();
    if (print) print_head();
    for (const Drop& drop : drops) {
        const std::vector<Broken> plates = broken_plates(drop, choices);
        for (std::size_t i = 0; i < plates.size(); ++i) {
            if (print) print_plate(drop, choices[i], plates[i]);
            json.push_back({{"edge", drop.edge},
                            {"faces", plates[i].race.faces},
                            {"choice", choices[i].name},
                            {"flight", steps_json(plates[i].flight)},
                            {"quiet", steps_json(plates[i].quiet)},
                            {"cracking", steps_json(plates[i].cracking)},
                            {"one_factorization", plates[i].factorization},
                            {"failure", plates[i].race.failure}});
        }
        page.charts.push_back(time_chart(drop, choices, plates));
    }
    return {json, page_svg(page)};
}

}  // namespace sherd
