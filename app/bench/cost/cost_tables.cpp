// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/cost_tables.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/bench/cost/newton_cost.h"
#include "app/bench/shell/shell_case.h"
#include "app/bench/shell/shell_run.h"
#include "app/machine/processor_time.h"
#include "app/messages/print.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {
namespace {

/// Cost of an explicit step, with the evaluation of breaking at its end.
struct ExplicitCost {
    std::size_t faces = 0;
    double parts = 0;  ///< mean number of parts of all substeps in a step
    double step = 0;   ///< s, of the fastest step: processor time with one thread, wall time with several
};

constexpr int steps_before = 10;  // steps that are not measured, until the disc is in contact

constexpr int steps = 60;  // measured steps, of which only the fastest counts

std::string scene_of(const std::string& model) {
    const ShellVariant variant = shell_variant(model, 0, false);
    std::string text = R"(
duration = 1
[sheet.disc]
mesh = { generate = "plate", radius = 0.075, edge_length = 0.0027 }
place = { translate = [0, 0, 0.0006] }
velocity = [0, 0, -5]
material = { preset = "glass", thickness = 0.001 }
[obstacle.nose]
sphere = { centre = [0, 0, -0.01], radius = 0.01 }
[contact]
sheets = false
[solver]
scheme = "explicit"
)";
    text += fmt::format("bending = \"{}\"\n", variant.bending);
    if (!variant.membrane.empty()) text += fmt::format("membrane = \"{}\"\n", variant.membrane);
    return text;
}

/// Measures explicit steps of 2e-6 s on a glass disc of about 6,000 faces that falls on a ball; sheets do not
/// touch each other, and nothing breaks. model: see shell_variant().
ExplicitCost explicit_cost(const std::string& model, int threads) {
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(parse_scene(scene_of(model), "bench", {}), warnings);
    built.options.stepper.threads = threads;
    Simulation simulation(std::move(built.sheets), built.options);
    for (int i = 0; i < steps_before; ++i) simulation.step();
    ExplicitCost cost;
    cost.faces = simulation.shell().mechanics().triangles.size();
    const auto step = [&] { cost.parts += simulation.step().newton_iterations; };
    cost.step = threads == 1 ? least_seconds(steps, step) : least_wall_seconds(steps, step);
    cost.parts /= steps;
    return cost;
}

const ShellCase& hemisphere_case(const std::vector<ShellCase>& all) {
    for (const ShellCase& one : all)
        if (one.name.starts_with("hemisphere")) return one;
    throw std::logic_error("no hemisphere");
}

void print_cost(const std::string& model, const NewtonCost& cost, const NewtonCost& first) {
    print_result(
        "| {} | {} | {:.0f} ({:.1f}) | {:.0f} ({:.1f}) | {:.2f} ({:.1f}) | {:.2f} ({:.1f}) | "
        "{:.2f} ({:.1f}) | {:.2f} ({:.1f}) | {:.2f} ({:.1f}) | {:.2f} ({:.1f}) |\n",
        cost.vertices, model, cost.hessian_entries, cost.hessian_entries / first.hessian_entries,
        cost.factor_entries, cost.factor_entries / first.factor_entries, 1e3 * cost.gradient,
        cost.gradient / first.gradient, 1e3 * cost.hessian, cost.hessian / first.hessian,
        1e3 * cost.factorization, cost.factorization / first.factorization, 1e3 * cost.iteration,
        cost.iteration / first.iteration, 1e3 * cost.layout, cost.layout / first.layout, 1e3 * cost.analysis,
        cost.analysis / first.analysis);
    std::fflush(stdout);
}

Json cost_json(const std::string& model, const NewtonCost& cost) {
    return {{"model", model},
            {"vertices", cost.vertices},
            {"hessian_entries", cost.hessian_entries},
            {"factor_entries", cost.factor_entries},
            {"gradient", cost.gradient},
            {"hessian", cost.hessian},
            {"factorization", cost.factorization},
            {"iteration", cost.iteration},
            {"layout", cost.layout},
            {"analysis", cost.analysis}};
}

/// The run of a case on a mesh.
struct Solved {
    double edge;  ///< length of the mesh's edges
    ShellRun run;
};

/// Result of needed_for().
struct Needed {
    std::optional<Solved> solved = {};  ///< run on the mesh; none: even the finest one is too coarse
    double finest_error = 0;            ///< %, largest error on the finest mesh
};

/// Finds the coarsest mesh of the case on which, as on all finer ones, no error of the model exceeds `error`
/// (%, as in ShellResult::error()).
Needed needed_for(const ShellCase& one, const std::string& model, double error) {
    Needed needed;
    for (std::size_t i = one.edges.size(); i-- > 0;) {  // from the finest mesh to the first too coarse one
        const Solved solved{one.edges[i], run_case(one, shell_variant(model, one.edges[i], false))};
        const double found = solved.run.largest_error();
        if (i + 1 == one.edges.size()) needed.finest_error = found;
        if (!solved.run.failure.empty() || found > error) break;
        needed.solved = solved;
    }
    return needed;
}

Json equal_json(const ShellCase& one, const Solved& coupled, const std::string& model, const Needed& needed) {
    Json row{
        {"case", one.name},  {"error", coupled.run.largest_error()}, {"coupled_seconds", coupled.run.seconds},
        {"model", model},    {"finest_error", needed.finest_error},  {"edge", nullptr},
        {"seconds", nullptr}};
    if (needed.solved) row["edge"] = needed.solved->edge, row["seconds"] = needed.solved->run.seconds;
    return row;
}

void print_equal(const ShellCase& one, const Solved& coupled, const std::string& model,
                 const Needed& needed) {
    print_result("| {} | {:.2f} | {}: {} | {} | ", one.name, coupled.run.largest_error(), coupled.edge,
                 coupled.run.faces, model);
    if (needed.solved)
        print_result("{}: {} | {:.1f} |\n", needed.solved->edge, needed.solved->run.faces,
                     needed.solved->run.seconds / coupled.run.seconds);
    else
        print_result("never: {:.1f} % at {} | |\n", needed.finest_error, one.edges.back());
    std::fflush(stdout);
}

}  // namespace

Json iteration_costs(const std::vector<std::string>& models, const std::vector<double>& edges, bool print) {
    const std::vector<ShellCase> all = sze_cases();
    if (print)
        print_result(
            "\n**An iteration of Newton's method** on the hemisphere with a hole, and what a crack "
            "adds: entries a vertex, and ms of processor time of one thread (times that of {})\n\n"
            "| vertices | model | Hessian | factor | gradient | assembly of the Hessian | factorization | "
            "iteration | layout | analysis |\n"
            "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
            models.front());
    Json rows = Json::array();
    for (const double edge : edges) {
        std::optional<NewtonCost> first;
        for (const std::string& model : models) {
            const NewtonCost cost = newton_cost(parse_scene(
                scene_text(hemisphere_case(all), shell_variant(model, edge, false)), "bench", {}));
            if (!first) first = cost;
            if (print) print_cost(model, cost, *first);
            rows.push_back(cost_json(model, cost));
        }
    }
    return rows;
}

Json explicit_costs(const std::vector<std::string>& models, bool print) {
    if (print)
        print_result(
            "\n**Explicit steps** of 2e-6 s of a disc that falls on a steel nose: ms, with one thread of "
            "processor time, with two of wall time\n\n"
            "| model | faces | parts of substeps a step | a step, one thread | two |\n"
            "| --- | --- | --- | --- | --- |\n");
    Json rows = Json::array();
    for (const std::string& model : models) {
        const ExplicitCost one = explicit_cost(model, 1), two = explicit_cost(model, 2);
        if (print)
            print_result("| {} | {} | {:.1f} | {:.2f} | {:.2f} |\n", model, one.faces, one.parts,
                         1e3 * one.step, 1e3 * two.step);
        std::fflush(stdout);
        rows.push_back({{"model", model},
                        {"faces", one.faces},
                        {"parts", one.parts},
                        {"step", one.step},
                        {"step_of_two_threads", two.step}});
    }
    return rows;
}

Json costs_at_equal_error(const std::vector<ShellCase>& cases, const std::vector<std::string>& models,
                          bool print) {
    if (print)
        print_result(
            "\n**At equal error**: the coarsest mesh from which on the largest of a case's errors stays "
            "below that of coupled hinges on the coarse mesh, and its processor time over theirs\n\n"
            "| case | error, % | edges: faces, `coupled` | model | edges: faces | times the cost |\n"
            "| --- | --- | --- | --- | --- | --- |\n");
    Json rows = Json::array();
    for (const ShellCase& one : cases) {
        const Solved coupled{one.edges[0], run_case(one, {.edge = one.edges[0]})};
        for (const std::string& model : models) {
            if (model == "coupled") continue;
            const Needed needed = needed_for(one, model, coupled.run.largest_error());
            if (print) print_equal(one, coupled, model, needed);
            rows.push_back(equal_json(one, coupled, model, needed));
        }
    }
    return rows;
}

}  // namespace sherd
