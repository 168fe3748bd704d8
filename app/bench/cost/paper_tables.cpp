// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/paper_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/bench/cost/paper_experiment.h"
#include "app/bench/cost/statistics.h"
#include "app/bench/cost/table_head.h"
#include "app/chart/chart_page.h"
#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// A case and its results, one for each solver choice.
struct Done {
    PaperCase of;
    std::vector<PaperResult> results;

    std::size_t vertices() const { return results.front().race.vertices; }
};

std::vector<PaperCase> chosen_paper_cases(const std::string& only, bool quick, double most_vertices) {
    std::vector<PaperCase> cases = paper_cases(quick, most_vertices);
    std::erase_if(cases,
                  [&](const PaperCase& one) { return one.scene.name.find(only) == std::string::npos; });
    if (!cases.empty()) return cases;
    std::string names;
    for (const PaperScene& scene : paper_scenes()) names += "\n  " + scene.name;
    throw Error(fmt::format("--only {}: no scene has this in its name; there are:{}", only, names));
}

void print_head(const PaperScene& scene, const std::vector<SolverChoice>& choices) {
    std::vector<std::string> columns{"step (s)", "mesh", "vertices"};
    for (const SolverChoice& choice : choices) columns.push_back(choice.name);
    print_result(
        "\n**{}**: simulated over processor time with {}; with the others, multiples of it, or for coupled "
        "hinges of the first coupled choice\n"
        "\n"
        "{}",
        scene.name, choices.front().name, table_head(columns));
}

void print_row(const Done& done, const std::vector<SolverChoice>& choices) {
    print_result("| {:g} | {} x {} | {} |", done.of.step, done.of.side, done.of.side, done.vertices());
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const PaperResult& result = done.results[i];
        const char* const mark = !result.race.failure.empty() ? " (2)" : result.race.is_out ? " (1)" : "";
        if (choices[i].beside == choices[i].name)
            print_result(" {:.3g}{} |", result.race.cost().rate(), mark);
        else
            print_result(" {:.2f}{} |", result.ratio, mark);
    }
    print_result("\n");
    std::fflush(stdout);
}

/// Results of one solver choice in all cases.
struct Summary {
    std::vector<double> ratios;       ///< for each case, rate of the choice over that of SolverChoice::beside
    std::vector<double> of_first;     ///< for each case, rate of the choice over that of the first choice
    std::vector<double> differences;  ///< PaperResult::difference where it is finite
    StepCost cost;
    int unfinished = 0;
};

Summary summary_of(const std::vector<Done>& all, std::size_t i) {
    Summary summary;
    for (const Done& done : all) {
        const PaperResult& result = done.results[i];
        if (result.ratio > 0) summary.ratios.push_back(result.ratio);
        const StepCost cost = result.race.cost();
        if (result.race.failure.empty())
            summary.of_first.push_back(cost.rate() / done.results.front().race.cost().rate());
        if (std::isfinite(result.difference)) summary.differences.push_back(result.difference);
        summary.cost += cost;
        summary.unfinished += !result.race.has_finished();
    }
    return summary;
}

std::string words_of(const std::vector<double>& differences) {
    if (differences.empty()) return "-";
    return fmt::format("{:.1g}, {:.1g}", median(differences), std::ranges::max(differences));
}

void print_summary(const std::vector<Done>& all, const std::vector<SolverChoice>& choices) {
    print_result(
        "\n**All {} cases**: multiples of the choice beside it, and the largest distance of a vertex from "
        "its place with the first choice of the same energies (median and largest of all cases)\n"
        "\n"
        "{}",
        all.size(),
        table_head({"choice", "beside", "median", "least", "most", "median beside " + choices.front().name,
                    "distance (edges)", "iterations a step", "factorizations a step", "unfinished"}));
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const Summary summary = summary_of(all, i);
        if (summary.ratios.empty()) continue;
        const auto [least, most] = std::ranges::minmax(summary.ratios);
        const auto steps = static_cast<double>(summary.cost.steps);
        print_result("| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {} | {:.1f} | {:.2f} | {} |\n",
                     choices[i].name, choices[i].beside, median(summary.ratios), least, most,
                     median(summary.of_first), words_of(summary.differences),
                     static_cast<double>(summary.cost.iterations) / steps,
                     static_cast<double>(summary.cost.factorizations) / steps, summary.unfinished);
    }
    print_result(
        "\n(1) took too long and was stopped: its steps until then count. (2) has a step that cannot be "
        "solved.\n");
}

Json result_json(const Done& done, const SolverChoice& choice, const PaperResult& result) {
    const StepCost cost = result.race.cost();
    Json row{{"scene", done.of.scene.name},   {"step", done.of.step},
             {"side", done.of.side},          {"vertices", result.race.vertices},
             {"choice", choice.name},         {"beside", choice.beside},
             {"simulated", cost.simulated},   {"seconds", cost.seconds},
             {"ratio", result.ratio},         {"steps", cost.steps},
             {"iterations", cost.iterations}, {"factorizations", cost.factorizations},
             {"analyses", cost.analyses},     {"halvings", result.race.halvings},
             {"stopped", result.race.is_out}, {"failure", result.race.failure},
             {"difference", nullptr}};
    if (std::isfinite(result.difference)) row["difference"] = result.difference;
    return row;
}

/// The rates in one scene: over the size of steps on the mesh of the first case or, unless `over_step`, over
/// the number of vertices with the size of steps of the last case.
Chart rate_chart(const std::vector<Done>& all, const std::string& scene, bool over_step,
                 const std::vector<SolverChoice>& choices) {
    const std::vector<Done> of_scene = [&] {
        std::vector<Done> found;
        for (const Done& done : all)
            if (done.of.scene.name == scene) found.push_back(done);
        return found;
    }();
    const PaperCase &first = of_scene.front().of, &last = of_scene.back().of;
    Chart chart{over_step ? fmt::format("{}, {} x {}", scene, first.side, first.side)
                          : fmt::format("{}, steps of {:g} s", scene, last.step),
                over_step ? ChartAxis{.name = "step (s)", .logarithmic = true}
                          : ChartAxis{.name = "vertices", .logarithmic = true},
                {.name = "simulated / processor time", .logarithmic = true},
                {}};
    for (std::size_t i = 0; i < choices.size(); ++i) {
        ChartSeries series{.name = choices[i].name,
                           .colour = choices[i].colour,
                           .points = {},
                           .dashed = choices[i].dashed,
                           .dotted = true};
        for (const Done& done : of_scene) {
            if (over_step ? done.of.side != first.side : done.of.step != last.step) continue;
            if (!done.results[i].race.failure.empty()) continue;
            series.points.emplace_back(over_step ? done.of.step : static_cast<double>(done.vertices()),
                                       done.results[i].race.cost().rate());
        }
        std::ranges::sort(series.points, {}, [](const Vector2d& point) { return point.x(); });
        chart.series.push_back(std::move(series));
    }
    return chart;
}

std::string figure_svg(const std::vector<Done>& all, const std::vector<SolverChoice>& choices) {
    std::vector<std::string> scenes;
    for (const Done& done : all)
        if (std::ranges::find(scenes, done.of.scene.name) == scenes.end())
            scenes.push_back(done.of.scene.name);
    ChartPage page{.heading = "Simulated time over processor time",
                   .columns = scenes.size(),
                   .panel_width = 400,
                   .shares_legend = true};
    for (const bool over_step : {true, false})
        for (const std::string& scene : scenes)
            page.charts.push_back(rate_chart(all, scene, over_step, choices));
    return page_svg(page);
}

}  // namespace

std::pair<Json, std::string> paper_figure(const std::string& only, bool quick, double most_vertices,
                                          bool print) {
    const std::vector<SolverChoice> choices = solver_choices();
    std::vector<Done> all;
    Json json = Json::array();
    for (const PaperCase& one : chosen_paper_cases(only, quick, most_vertices)) {
        if (print && (all.empty() || all.back().of.scene.name != one.scene.name))
            print_head(one.scene, choices);
        all.push_back({one, run_paper_case(one, choices)});
        if (print) print_row(all.back(), choices);
        for (std::size_t i = 0; i < choices.size(); ++i)
            json.push_back(result_json(all.back(), choices[i], all.back().results[i]));
    }
    if (print) print_summary(all, choices);
    return {json, figure_svg(all, choices)};
}

}  // namespace sherd
