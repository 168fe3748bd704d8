// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

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
    for (ShellCase& one : sze_cases())
        if (one.name.find(options.only) != std::string::npos) chosen.push_back(std::move(one));
    if (!chosen.empty()) return chosen;
    std::string names;
    for (const ShellCase& one : sze_cases()) names += "\n  " + one.name;
    throw Error(fmt::format("--only {}: no case has this in its name; there are:{}", options.only, names));
}

/// BENDING or BENDING+MEMBRANE, as solver.bending and solver.membrane have them.
ShellVariant variant_of(const std::string& model, double edge, bool structured) {
    const std::size_t plus = model.find('+');
    return {edge, structured, model.substr(0, plus), plus == std::string::npos ? "" : model.substr(plus + 1)};
}

/// Quickly: the two coarser meshes, unstructured, of coupled hinges.
std::vector<ShellVariant> variants_of(const ShellCase& one, const BenchOptions& options) {
    std::vector<ShellVariant> variants;
    if (options.quick) return {{one.edges[0]}, {one.edges[1]}};
    for (const std::string& model : options.models)
        for (const bool structured : {false, true})
            for (const double edge : one.edges) variants.push_back(variant_of(model, edge, structured));
    return variants;
}

std::string model_words(const ShellVariant& variant) {
    return variant.bending + (variant.membrane.empty() ? "" : "+" + variant.membrane);
}

void print_row(const ShellVariant& variant, const ShellRun& run) {
    fmt::print("| {} | {} | {} | {} |", model_words(variant),
               variant.structured ? "structured" : "unstructured", variant.edge, run.faces);
    for (const ShellResult& result : run.results) fmt::print(" {:.1f}", result.error());
    fmt::print(" | {} | {:.1f} |{}\n", run.iterations, run.seconds, run.failure.empty() ? "" : " (1)");
    std::fflush(stdout);
}

Json row_json(const ShellCase& one, const ShellVariant& variant, const ShellRun& run) {
    Json row{{"case", one.name},        {"model", model_words(variant)},
             {"edge", variant.edge},    {"structured", variant.structured},
             {"faces", run.faces},      {"iterations", run.iterations},
             {"seconds", run.seconds},  {"failure", run.failure},
             {"results", Json::array()}};
    for (const ShellResult& result : run.results)
        row["results"].push_back(
            {{"name", result.name}, {"value", result.value}, {"reference", result.reference}});
    return row;
}

void print_head(const ShellCase& one) {
    fmt::print("\n**{}**: errors in % of", one.name);
    const char* separator = " ";
    for (const ShellReference& reference : one.references) {
        fmt::print("{}{} at {}", separator, reference.name, reference.load);
        separator = ", ";
    }
    if (!one.limits.empty()) fmt::print(" highest load, -W there, lowest load, -W there");
    fmt::print(
        "\n\n| model | mesh | edges | faces | errors | iterations | s |\n"
        "| --- | --- | --- | --- | --- | --- | --- |\n");
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
                failures += fmt::format("{}, {}, {}: {}\n", one.name, model_words(variant), variant.edge,
                                        run.failure);
        }
    }
    if (options.json) fmt::print("{}\n", rows.dump(2));
    if (!options.json && !failures.empty()) fmt::print("\n(1) was not computed to its end:\n{}", failures);
    return 0;
}

}  // namespace

void add_bench(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("bench", "Compare with published numbers, in a table that anyone can make");
    auto options = std::make_shared<BenchOptions>();
    command
        ->add_option("name", options->name,
                     "shells: large deflections of plates and shells (Sze, Liu, Lo 2004)")
        ->required()
        ->check(CLI::IsMember({"shells"}));
    command->add_flag("--quick", options->quick,
                      "Under two minutes: the two coarser of three meshes, unstructured, of coupled hinges");
    command->add_option("--only", options->only, "Take the cases with this in their names")
        ->option_text("TEXT");
    command
        ->add_option("--models", options->models,
                     "solver.bending, or with +arc or +constant-strain solver.membrane, too (default cubic "
                     "coupled coupled+arc)")
        ->option_text("MODEL ...");
    command->add_flag("--json", options->json, "For scripts: one JSON array");
    command->footer("Example:\n  sherd bench shells --quick --only hemisphere");
    command->callback([&chosen, options] { chosen = [options] { return bench_shells(*options); }; });
}

}  // namespace sherd
