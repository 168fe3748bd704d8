// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost_tables.h"

#include <cstdio>
#include <optional>
#include <stdexcept>

#include "app/bench/explicit_cost.h"
#include "app/bench/newton_cost.h"
#include "app/bench/shell_run.h"
#include "app/messages/print.h"
#include "app/scene/read/scene.h"

namespace sherd {
namespace {

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

/// A mesh, and what it cost to compute the case on it.
struct Solved {
    double edge;
    ShellRun run;
};

/// The coarsest of the case's meshes from which on no error is above `error`; none: the finest has more.
struct Needed {
    std::optional<Solved> solved = {};
    double finest_error = 0;  ///< %
};

Needed needed_for(const ShellCase& one, const std::string& model, double error) {
    Needed needed;
    for (std::size_t i = one.edges.size(); i-- > 0;) {  // a mesh that is too coarse ends the search
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
            "processor time, with two of wall time; and million faces times substeps a second\n\n"
            "| model | faces | substeps a step | a step, one thread | two | a second, one thread | two |\n"
            "| --- | --- | --- | --- | --- | --- | --- |\n");
    Json rows = Json::array();
    std::size_t faces = 0;
    for (const std::string& model : models) {
        const ExplicitCost one = explicit_cost(model, 1), two = explicit_cost(model, 2);
        faces = one.faces;
        if (print)
            print_result("| {} | {} | {:.1f} | {:.2f} | {:.2f} | {:.1f} | {:.1f} |\n", model, faces,
                         one.substeps, 1e3 * one.step, 1e3 * two.step, 1e-6 * one.face_steps(),
                         1e-6 * two.face_steps());
        std::fflush(stdout);
        rows.push_back({{"model", model},
                        {"faces", faces},
                        {"substeps", one.substeps},
                        {"step", one.step},
                        {"step_of_two_threads", two.step}});
    }
    if (print)
        print_result("\nMemory alone would let one thread make {:.0f} million a second.\n",
                     1e-6 * explicit_bound(faces));
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
