// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>

#include "app/bench/cost/cost_tables.h"
#include "app/bench/cost/cracking_tables.h"
#include "app/bench/cost/paper_tables.h"
#include "app/bench/cost/scaling_tables.h"
#include "app/bench/fracture/fracture_tables.h"
#include "app/bench/shell/shell_run.h"
#include "app/commands/number_check.h"
#include "app/commands/program.h"
#include "app/files/disk/pending_file.h"
#include "app/json/json.h"
#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The command line of `sherd-bench`.
struct BenchOptions {
    std::string name, only;
    std::vector<std::string> models{"cubic", "coupled", "coupled+arc"};
    std::filesystem::path figure;
    double most_vertices = 102400;
    bool quick = false, json = false, force = false;
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

/// The meshes and models with which a case is computed: all or, with --quick, the two coarser unstructured
/// meshes with coupled hinges.
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
    print_result("| {} | {} | {} | {} |", variant.model(), variant.structured ? "structured" : "unstructured",
                 variant.edge, run.faces);
    for (const ShellResult& result : run.results) print_result(" {:.1f}", result.error());
    print_result(" | {} | {:.2f} |{}\n", run.iterations, run.seconds, run.failure.empty() ? "" : " (1)");
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
    print_result("\n**{}**{}{}: errors in % of {}\n\n", one.name, one.source.empty() ? "" : ", beside ",
                 one.source, known_numbers(one));
    print_result(
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
    if (options.json) print_result("{}\n", rows.dump(2));
    if (!options.json && !failures.empty()) print_result("\n(1) was not computed to its end:\n{}", failures);
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
        print_result("{}\n",
                     Json{{"iterations", costs}, {"explicit", explicits}, {"equal_error", equal}}.dump(2));
    return 0;
}

int bench_fracture(const BenchOptions& options) {
    const Json runs = fracture_experiments(options.only, options.quick, !options.json);
    if (options.json) print_result("{}\n", runs.dump(2));
    return 0;
}

/// The results of an experiment as JSON, and its figure as SVG.
using Experiment = std::pair<Json, std::string>;

/// Runs an experiment, and writes its figure if the options name a file for it. Throws Error before the
/// experiment if this file exists and may not be replaced.
int bench_speed(const BenchOptions& options, const std::function<Experiment()>& experiment) {
    std::optional<OutputLock> lock;
    if (!options.figure.empty()) {
        lock.emplace(options.figure);
        check_free(options.figure, options.force);
    }
    const auto [json, figure] = experiment();
    if (options.json) print_result("{}\n", json.dump(2));
    if (!lock) return 0;
    PendingFile pending(*lock, Fault::input);
    pending.write(figure);
    pending.publish(options.force);
    return 0;
}

int bench_paper(const BenchOptions& options) {
    return bench_speed(options, [&] {
        return paper_figure(options.only, options.quick, options.most_vertices, !options.json);
    });
}

int bench_scaling(const BenchOptions& options) {
    const double most = options.quick ? std::min(6400.0, options.most_vertices) : options.most_vertices;
    return bench_speed(options, [&] { return scaling(options.only, most, !options.json); });
}

int bench_cracking(const BenchOptions& options) {
    return bench_speed(options, [&] { return cracking(options.only, options.quick, !options.json); });
}

/// A benchmark of `sherd-bench`.
struct Bench {
    const char* name;
    const char* description;
    int (*run)(const BenchOptions&);
    bool has_figure = false;
};

constexpr std::array<Bench, 6> benches{
    {{"shells", "errors of plates and shells compared with theory and published numbers", bench_shells},
     {"cost", "cost of an iteration, of an explicit step and of a given error with each model", bench_cost},
     {"fracture", "crack growth compared with theory", bench_fracture},
     {"paper", "simulated time over processor time, as in figure 2 of Cubic Shells", bench_paper, true},
     {"scaling", "cost of quiet steps as the mesh grows, compared with lower bounds", bench_scaling, true},
     {"cracking", "cost of steps in which a plate cracks, compared with other steps", bench_cracking, true}}};

std::vector<std::string> names_of_benches() {
    std::vector<std::string> names;
    for (const Bench& bench : benches) names.emplace_back(bench.name);
    return names;
}

std::string words_of_benches() {
    std::vector<std::string> words;
    for (const Bench& bench : benches) words.push_back(fmt::format("{}: {}", bench.name, bench.description));
    return fmt::format("{}", fmt::join(words, "; "));
}

int run_bench(const BenchOptions& options) {
    const Bench& bench = *std::ranges::find(benches, options.name, &Bench::name);
    if (!options.figure.empty() && !bench.has_figure)
        throw Error(fmt::format("-o: sherd-bench {} draws no figure", options.name));
    return bench.run(options);
}

}  // namespace
}  // namespace sherd

// NOLINTNEXTLINE(bugprone-exception-escape): before run_program(), only a lack of memory could throw.
int main(int argc, char** argv) {
    using namespace sherd;
    prepare_process();
    CLI::App program(
        "Compares Sherd with theory, with published numbers and with itself, in tables that anyone can "
        "reproduce.",
        "sherd-bench");
    BenchOptions options;
    program.add_option("name", options.name, words_of_benches())
        ->required()
        ->check(CLI::IsMember(names_of_benches()));
    program.add_flag(
        "--quick", options.quick,
        "Under two minutes: for shells the two coarser of three unstructured meshes, with coupled hinges; "
        "for cost the coarsest mesh and plates only; for fracture one mesh for each of the two coarser edge "
        "lengths; for paper and scaling the coarser meshes; for cracking the coarser mesh, and less time");
    program
        .add_option(
            "--only", options.only,
            "Run only the cases with this in their names; for scaling and cracking, the choices of a solver")
        ->option_text("TEXT");
    program
        .add_option("--models", options.models,
                    "Models: solver.bending, or solver.bending and solver.membrane, with +arc or "
                    "+constant-strain (default cubic coupled coupled+arc)")
        ->option_text("MODEL ...");
    program
        .add_option("--vertices", options.most_vertices,
                    "For scaling: vertices of the largest mesh (default 102400), each mesh having four times "
                    "as many as the one before; for paper: of the largest mesh that is used")
        ->check(number_within(1600, 1e8))
        ->option_text("NUMBER");
    program.add_option("-o,--output", options.figure, "For paper, scaling and cracking: draw a figure, too")
        ->option_text("FILE.svg");
    program.add_flag("--force", options.force, "Replace a file that exists");
    program.add_flag("--json", options.json,
                     "For scripts: one JSON array; for cost and scaling, one JSON object");
    program.footer(
        "Example:\n  sherd-bench shells --quick --only hemisphere\n  sherd-bench paper --quick -o rates.svg");
    return run_program(
        program, [&] { return run_bench(options); }, argc, argv);
}
