// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/fracture/fracture_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "app/bench/fracture/fracture_run.h"
#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<FractureCase> chosen_experiments(const std::string& only) {
    std::vector<FractureCase> chosen;
    std::string names;
    for (FractureCase& one : fracture_cases()) {
        names += "\n  " + one.name;
        if (one.name.find(only) != std::string::npos) chosen.push_back(std::move(one));
    }
    if (chosen.empty())
        throw Error(fmt::format("--only {}: no experiment has this in its name; there are:{}", only, names));
    return chosen;
}

void print_head(const FractureCase& one) {
    print_result("\n**{}**{}{}\n\n| edges / {} | faces |", one.name, one.source.empty() ? "" : ", beside ",
                 one.source, one.in_units);
    for (const FractureNumber& number : one.numbers) print_result(" {} |", number.name);
    print_result(" s a run |\n| --- | --- |");
    for (std::size_t i = 0; i <= one.numbers.size(); ++i) print_result(" --- |");
    print_result("\n");
    std::fflush(stdout);
}

/// Mean and standard deviation of the i-th number over the runs that have it, "0.98 ± 0.01", and a mark if
/// the mean differs from theory by more than number.bound.
std::string spread_words(const FractureNumber& number, const std::vector<FractureRun>& runs, std::size_t i) {
    double sum = 0, squares = 0;
    int count = 0;
    for (const FractureRun& run : runs)
        if (!run.values.empty()) {
            sum += run.values[i];
            ++count;
        }
    if (count == 0) return "-";
    const double mean = sum / count;
    for (const FractureRun& run : runs)
        if (!run.values.empty()) squares += (run.values[i] - mean) * (run.values[i] - mean);
    const int digits = number.bound >= 1 ? 1 : 3;
    return fmt::format("{:.{}f} ± {:.{}f}{}", mean, digits, std::sqrt(squares / count), digits,
                       std::abs(mean - number.theory) > number.bound ? " (!)" : "");
}

void print_row(const FractureCase& one, double edge, const std::vector<FractureRun>& runs) {
    double seconds = 0;
    for (const FractureRun& run : runs) seconds += run.seconds / static_cast<double>(runs.size());
    print_result("| {:.2g} | {} |", edge / one.unit, runs.front().faces);
    for (std::size_t i = 0; i < one.numbers.size(); ++i)
        print_result(" {} |", spread_words(one.numbers[i], runs, i));
    print_result(" {:.1f} |\n", seconds);
    std::fflush(stdout);
}

Json run_json(const FractureCase& one, double edge, int seed, const FractureRun& run) {
    Json json{{"case", one.name},        {"edge", edge},           {"seed", seed},
              {"faces", run.faces},      {"seconds", run.seconds}, {"failure", run.failure},
              {"results", Json::array()}};
    for (std::size_t i = 0; i < run.values.size(); ++i)
        json["results"].push_back({{"name", one.numbers[i].name},
                                   {"value", run.values[i]},
                                   {"theory", one.numbers[i].theory},
                                   {"bound", one.numbers[i].bound}});
    if (one.compares_paths)
        for (const Vector2d& point : run.path) json["path"].push_back({point.x(), point.y()});
    return json;
}

/// Runs a case, and prints a row of its numbers after the runs of each length of edges, if `print`.
class Experiment {
  public:
    Experiment(const FractureCase& one, bool print) : one(one), print(print) {
        if (print) print_head(one);
    }
    void add_row(double edge, int seeds, Json& json) {
        std::vector<FractureRun> runs;
        for (int seed = 1; seed <= seeds; ++seed) {
            runs.push_back(run_fracture(one, edge, seed));
            json.push_back(run_json(one, edge, seed, runs.back()));
            if (!runs.back().path.empty()) paths.push_back(runs.back().path);
            if (!runs.back().failure.empty())
                failures += fmt::format("\nEdges of {} m, seed {}: {}\n", edge, seed, runs.back().failure);
        }
        if (print) print_row(one, edge, runs);
    }
    void finish() const {
        if (!print) return;
        if (one.compares_paths)
            print_result(
                "\nAny two of these {} paths are within {:.2f} of the coarsest edges of each other.\n",
                paths.size(), largest_distance(paths) / one.edges.front());
        print_result("{}", failures);
        std::fflush(stdout);
    }

  private:
    const FractureCase& one;
    bool print;
    std::vector<std::vector<Vector2d>> paths;
    std::string failures;
};

}  // namespace

Json fracture_experiments(const std::string& only, bool quick, bool print) {
    Json json = Json::array();
    for (const FractureCase& one : chosen_experiments(only)) {
        Experiment experiment(one, print);
        for (std::size_t i = 0; i < (quick ? 2 : one.edges.size()); ++i)
            experiment.add_row(one.edges[i], quick ? 1 : 3, json);
        experiment.finish();
    }
    if (print) print_result("\n(!) differs from theory by more than is required.\n");
    return json;
}

}  // namespace sherd
