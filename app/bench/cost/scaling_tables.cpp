// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/scaling_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "app/bench/cost/newton_cost.h"
#include "app/bench/cost/race.h"
#include "app/bench/cost/solver_choice.h"
#include "app/bench/cost/statistics.h"
#include "app/bench/cost/table_head.h"
#include "app/chart/chart_page.h"
#include "app/machine/memory.h"
#include "app/messages/print.h"
#include "app/scene/read/scene.h"

namespace sherd {
namespace {

constexpr double fewest_vertices = 400, growth = 4;
constexpr double fitted_from = 1000;  // fewest vertices in fits, since smaller meshes fit into the caches
constexpr double side = 0.5;          // m, of the square pane

/// A pane of glass with about this many vertices, which is clamped at one side, has an initial velocity, and
/// neither touches anything nor breaks.
Scene pane(double vertices, const SolverChoice& choice) {
    const double edge = side / std::sqrt(0.5 * std::sqrt(3) * vertices);
    return parse_scene(fmt::format(R"(duration = 1
[sheet.pane]
mesh = {{ generate = "rectangle", width = {0}, height = {0}, edge_length = {1} }}
clamp = {{ box = [[-1, -1, -1], [1e-6, 1, 1]] }}
velocity = [0, 0, 1]
material = {{ preset = "glass", thickness = 0.001 }}
[solver]
step = 1e-4
)",
                                   side, edge),
                       "bench", {choice.settings, ""});
}

/// Measured steps with one solver choice on one mesh.
struct Quiet {
    const SolverChoice& choice;
    RaceResult race;
    NewtonCost bound;   ///< cost of a Newton iteration with the same energies, for lower bounds
    double two_passes;  ///< s, to read the factor in double precision twice from memory

    double vertices() const { return static_cast<double>(race.vertices); }
    double in_step(std::int64_t StepCost::*number) const {
        return static_cast<double>(race.cost().*number) / static_cast<double>(race.cost().steps);
    }
    double step() const { return race.cost().seconds / static_cast<double>(race.cost().steps); }
    double iteration() const { return step() / in_step(&StepCost::iterations); }
    bool is_known() const { return race.failure.empty() && race.cost().steps > 0; }
};

/// Measures all choices on a mesh of about `vertices` vertices. bandwidth: of the memory, bytes/s.
std::vector<Quiet> quiet_steps(double vertices, const std::vector<SolverChoice>& choices, double bandwidth) {
    std::map<std::string, NewtonCost> bounds;
    std::vector<Scene> scenes;
    for (const SolverChoice& choice : choices) {
        scenes.push_back(pane(vertices, choice));
        if (!bounds.contains(choice.energies)) bounds[choice.energies] = newton_cost(scenes.back());
    }
    std::vector<RaceResult> raced = race(scenes, {.step = scenes.front().simulation.stepper.step, .laps = 6});
    std::vector<Quiet> all;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const NewtonCost& bound = bounds[choices[i].energies];
        const double bytes = sizeof(double) * bound.factor_entries * static_cast<double>(bound.vertices);
        all.push_back({choices[i], std::move(raced[i]), bound, 2 * bytes / bandwidth});
    }
    return all;
}

void print_head(double bandwidth) {
    print_result(
        "\n**A quiet step** of a clamped pane of glass that moves: processor time, ms; beside it one "
        "factorization of its matrix, and two passes over the factor in double precision at {:.1f} GB/s, "
        "as fast as one thread reads from memory\n\n{}",
        1e-9 * bandwidth,
        table_head({"vertices", "choice", "step", "iterations", "factorizations", "one factorization",
                    "step over it", "two passes", "iteration over them", "memory (MB)"}));
    std::fflush(stdout);
}

void print_quiet(const Quiet& quiet) {
    print_result("| {} | {} | ", quiet.race.vertices, quiet.choice.name);
    if (quiet.is_known())
        print_result("{:.4g} | {:.1f} | {:.2f} | {:.4g} | {:.2f} | {:.3g} | {:.1f} | {:.0f} |\n",
                     1e3 * quiet.step(), quiet.in_step(&StepCost::iterations),
                     quiet.in_step(&StepCost::factorizations), 1e3 * quiet.bound.factorization,
                     quiet.step() / quiet.bound.factorization, 1e3 * quiet.two_passes,
                     quiet.iteration() / quiet.two_passes, 1e-6 * quiet.race.memory);
    else
        print_result("{} | | | | | | | |\n", quiet.race.is_out ? "too slow" : quiet.race.failure);
    std::fflush(stdout);
}

Json quiet_json(const Quiet& quiet) {
    return {{"vertices", quiet.race.vertices},
            {"choice", quiet.choice.name},
            {"step", quiet.is_known() ? Json(quiet.step()) : Json()},
            {"iterations", quiet.is_known() ? Json(quiet.in_step(&StepCost::iterations)) : Json()},
            {"factorizations", quiet.is_known() ? Json(quiet.in_step(&StepCost::factorizations)) : Json()},
            {"one_factorization", quiet.bound.factorization},
            {"one_solution", quiet.bound.solution},
            {"two_passes", quiet.two_passes},
            {"memory", quiet.race.memory},
            {"failure", quiet.race.failure}};
}

/// The line of a solver choice over the number of vertices in a chart. value: computes y from a Quiet.
template <class Value>
ChartSeries over_vertices(const std::vector<Quiet>& all, const SolverChoice& choice, Value value) {
    ChartSeries series{
        .name = choice.name, .colour = choice.colour, .points = {}, .dashed = choice.dashed, .dotted = true};
    for (const Quiet& quiet : all)
        if (quiet.choice.name == choice.name && quiet.is_known())
            series.points.emplace_back(quiet.vertices(), std::invoke(value, quiet));
    return series;
}

void print_growth(const std::vector<Quiet>& all, const std::vector<SolverChoice>& choices) {
    print_result("\n**Growth**: exponents p of vertices^p from {:.0f} vertices on\n\n{}", fitted_from,
                 table_head({"choice", "step", "iteration", "one factorization", "memory"}));
    for (const SolverChoice& choice : choices) {
        const auto exponent = [&](auto value) {
            std::vector<Vector2d> fitted = over_vertices(all, choice, value).points;
            std::erase_if(fitted,
                          [](const Vector2d& point) { return point.x() < fitted_from || point.y() <= 0; });
            return fitted.size() < 2 ? std::string("-") : fmt::format("{:.2f}", fitted_exponent(fitted));
        };
        print_result("| {} | {} | {} | {} | {} |\n", choice.name, exponent(&Quiet::step),
                     exponent(&Quiet::iteration),
                     exponent([](const Quiet& quiet) { return quiet.bound.factorization; }),
                     exponent([](const Quiet& quiet) { return 1e-6 * quiet.race.memory; }));
    }
}

std::string growth_svg(const std::vector<Quiet>& all, const std::vector<SolverChoice>& choices) {
    const ChartAxis vertices{.name = "vertices", .logarithmic = true};
    Chart steps{"A quiet step", vertices, {.name = "processor time", .unit = "s", .logarithmic = true}, {}};
    Chart memory{"Memory", vertices, {.name = "memory (MB)", .logarithmic = true}, {}};
    for (const SolverChoice& choice : choices) {
        steps.series.push_back(over_vertices(all, choice, &Quiet::step));
        memory.series.push_back(
            over_vertices(all, choice, [](const Quiet& quiet) { return 1e-6 * quiet.race.memory; }));
    }
    const auto add_bound = [&](const char* name, const char* colour, const SolverChoice& choice, auto value) {
        ChartSeries series = over_vertices(all, choice, value);
        series.name = fmt::format("{}, {}", name, choice.name);
        series.colour = colour;
        series.dashed = true;
        series.dotted = false;
        steps.series.push_back(std::move(series));
    };
    for (const SolverChoice& choice : choices) {
        if (choice.name != choice.beside && &choice != &choices.front()) continue;
        const char* const grey = choice.is_coupled() ? "#c08080" : "#999999";
        add_bound("one factorization", grey, choice,
                  [](const Quiet& quiet) { return quiet.bound.factorization; });
        add_bound("two passes", grey, choice, &Quiet::two_passes);
    }
    return page_svg({.heading = "Growth with the mesh (dashed and grey: lower bounds)",
                     .charts = {std::move(steps), std::move(memory)},
                     .panel_height = 360,
                     .shares_legend = true});
}

}  // namespace

std::pair<Json, std::string> scaling(const std::string& only, double most_vertices, bool print) {
    const std::vector<SolverChoice> choices = exact_choices(only);
    const double bandwidth = memory_bandwidth();
    if (print) print_head(bandwidth);
    std::vector<Quiet> all;
    Json json = Json::array();
    for (double vertices = fewest_vertices; vertices <= 1.1 * most_vertices; vertices *= growth)
        for (Quiet& quiet : quiet_steps(vertices, choices, bandwidth)) {
            if (print) print_quiet(quiet);
            json.push_back(quiet_json(quiet));
            all.push_back(std::move(quiet));
        }
    if (print) print_growth(all, choices);
    return {Json{{"bandwidth", bandwidth}, {"steps", json}}, growth_svg(all, choices)};
}

}  // namespace sherd
