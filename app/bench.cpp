// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "app/bench/cost_tables.h"
#include "app/bench/fracture_tables.h"
#include "app/bench/shell_run.h"
#include "app/commands.h"
#include "app/json/json.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The command line of `sherd bench`.
struct BenchOptions {
    std::string name, only;
    std::vector<std::string> models{"cubic", "coupled", "coupled+arc"};
    bool quick = false, json = false;
};

std::vector<ShellCase> chosen_cases(const BenchOptions& options) {
    std::vector<ShellCase> chosen;
    for (ShellCase& one : shell_cases())
        if (one.name.find(options.only) != std::string::npos) chosen.push_back(std::move(one));
    if (!chosen.empty()) return chosen;
    std::string names;
    for (const ShellCase& one : shell_cases()) names += "\n  " + one.name;
    throw Error(fmt::format("--only {}: no case has this in its name; there are:{}", options.only, names));
}

/// Quickly: the two coarser meshes, unstructured, of coupled hinges.
std::vector<ShellVariant> variants_of(const ShellCase& one, const BenchOptions& options) {
    std::vector<ShellVariant> variants;
    if (options.quick) return {{one.edges[0]}, {one.edges[1]}};
    for (const std::string& model : options.models)
        for (const bool structured : {false, true})
            for (const double edge : one.edges)
                if (!structured || one.has_structured)
                    variants.push_back(shell_variant(model, edge, structured));
    return variants;
}

void print_row(const ShellVariant& variant, const ShellRun& run) {
    fmt::print("| {} | {} | {} | {} |", variant.model(), variant.structured ? "structured" : "unstructured",
               variant.edge, run.faces);
    for (const ShellResult& result : run.results) fmt::print(" {:.1f}", result.error());
    fmt::print(" | {} | {:.2f} |{}\n", run.iterations, run.seconds, run.failure.empty() ? "" : " (1)");
    std::fflush(stdout);
}

Json row_json(const ShellCase& one, const ShellVariant& variant, const ShellRun& run) {
    Json row{{"case", one.name},        {"model", variant.model()},
             {"edge", variant.edge},    {"structured", variant.structured},
             {"faces", run.faces},      {"iterations", run.iterations},
             {"seconds", run.seconds},  {"failure", run.failure},
             {"results", Json::array()}};
    for (const ShellResult& result : run.results)
        row["results"].push_back(
            {{"name", result.name}, {"value", result.value}, {"reference", result.reference}});
    return row;
}

std::string known_numbers(const ShellCase& one) {
    std::vector<std::string> names;
    for (const ShellReference& reference : one.references)
        names.push_back(one.step < 1 ? fmt::format("{} at {}", reference.name, reference.load)
                                     : reference.name);
    if (!one.limits.empty()) names.emplace_back("highest load, -W there, lowest load, -W there");
    if (!one.frequencies.empty()) names.push_back(fmt::format("f1 to f{}", one.frequencies.size()));
    if (!one.measured.empty()) names.push_back(one.measured);
    return fmt::format("{}", fmt::join(names, ", "));
}

void print_head(const ShellCase& one) {
    fmt::print("\n**{}**{}{}: errors in % of {}\n\n", one.name, one.source.empty() ? "" : ", beside ",
               one.source, known_numbers(one));
    fmt::print(
        "| model | mesh | edges | faces | errors | iterations | s |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
    std::fflush(stdout);
}

int bench_shells(const BenchOptions& options) {
    Json rows = Json::array();
    std::string failures;
    for (const ShellCase& one : chosen_cases(options)) {
        if (!options.json) print_head(one);
        for (const ShellVariant& variant : variants_of(one, options)) {
            const ShellRun run = run_case(one, variant);
            if (options.json)
                rows.push_back(row_json(one, variant, run));
            else
                print_row(variant, run);
            if (!run.failure.empty())
                failures +=
                    fmt::format("{}, {}, {}: {}\n", one.name, variant.model(), variant.edge, run.failure);
        }
    }
    if (options.json) fmt::print("{}\n", rows.dump(2));
    if (!options.json && !failures.empty()) fmt::print("\n(1) was not computed to its end:\n{}", failures);
    return 0;
}

int bench_cost(const BenchOptions& options) {
    std::vector<double> edges(hemisphere_edges.begin(), hemisphere_edges.end());
    std::vector<ShellCase> cases = chosen_cases(options);
    if (options.quick) {
        edges.resize(1);
        if (options.only.empty())
            std::erase_if(cases, [](const ShellCase& one) { return !one.name.starts_with("plate"); });
    }
    const Json costs = iteration_costs(options.models, edges, !options.json);
    const Json explicits = explicit_costs(options.models, !options.json);
    const Json equal = costs_at_equal_error(cases, options.models, !options.json);
    if (options.json)
        fmt::print("{}\n",
                   Json{{"iterations", costs}, {"explicit", explicits}, {"equal_error", equal}}.dump(2));
    return 0;
}

int bench_fracture(const BenchOptions& options) {
    const Json runs = fracture_experiments(options.only, options.quick, !options.json);
    if (options.json) fmt::print("{}\n", runs.dump(2));
    return 0;
}

}  // namespace

void add_bench(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "bench", "Compare with theory and published numbers, in tables that anyone can make");
    auto options = std::make_shared<BenchOptions>();
    command
        ->add_option(
            "name", options->name,
            "shells: errors of plates and shells beside theory and published numbers; cost: what an "
            "iteration, an explicit step and a given error cost with each model; fracture: cracks that "
            "grow, beside theory")
        ->required()
        ->check(CLI::IsMember({"shells", "cost", "fracture"}));
    command->add_flag(
        "--quick", options->quick,
        "Under two minutes: the two coarser of three meshes, unstructured, of coupled hinges; of "
        "cost the coarsest mesh and plates only; of fracture one mesh of the two coarser ones");
    command->add_option("--only", options->only, "Take the cases with this in their names")
        ->option_text("TEXT");
    command
        ->add_option("--models", options->models,
                     "solver.bending, or with +arc or +constant-strain solver.membrane, too (default cubic "
                     "coupled coupled+arc)")
        ->option_text("MODEL ...");
    command->add_flag("--json", options->json, "For scripts: one JSON array, of cost one JSON object");
    command->footer("Example:\n  sherd bench shells --quick --only hemisphere");
    command->callback([&chosen, options] {
        chosen = [options] {
            if (options->name == "fracture") return bench_fracture(*options);
            return options->name == "cost" ? bench_cost(*options) : bench_shells(*options);
        };
    });
}

}  // namespace sherd
