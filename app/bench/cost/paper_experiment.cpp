// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/paper_experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd {
namespace {

constexpr int middle = 2;  // index of the middle one of the five sizes of steps

double edge_length(const PaperCase& one) {
    // A mesh of equilateral triangles has two triangles for each vertex.
    return std::sqrt(one.scene.area / (0.5 * std::sqrt(3) * one.side * one.side));
}

Scene scene_of(const PaperCase& one, const SolverChoice& choice, double step) {
    std::vector<std::string> settings = one.scene.settings;
    settings.insert(settings.end(), choice.settings.begin(), choice.settings.end());
    settings.push_back(fmt::format("solver.step={}", step));
    settings.push_back(fmt::format("sheet.{}.mesh.edge_length={}", one.scene.sheet, edge_length(one)));
    return read_scene(shipped_scene(one.scene.scene, shipped_scenes(shipped_scene_folder())).file,
                      {settings, "vertical"});
}

/// The largest distance between the end positions of a vertex in two runs, in lengths of an edge; NaN if the
/// runs did not make the same steps. edge: length of an edge, m.
double difference(const RaceResult& one, const RaceResult& other, double edge) {
    if (!one.has_finished() || !other.has_finished() || one.halvings + other.halvings > 0)
        return std::numeric_limits<double>::quiet_NaN();
    return (one.end.position - other.end.position).colwise().norm().maxCoeff() / edge;
}

/// Indices of the choices, in groups that race together. A group begins with the choice with which its other
/// choices are compared. It has at most four choices, since on the largest meshes each takes gigabytes; the
/// other choices are therefore distributed over several groups with the same beginning.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<SolverChoice>& choices) {
    constexpr std::size_t most = 4;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t first = 0; first < choices.size(); ++first) {
        if (place_beside(choices, first) != first) continue;
        groups.push_back({first});
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (i == first || place_beside(choices, i) != first) continue;
            if (groups.back().size() == most) groups.push_back({first});
            groups.back().push_back(i);
        }
    }
    return groups;
}

}  // namespace

std::vector<PaperScene> paper_scenes() {
    return {{.name = "flag",
             .scene = "paper/figure_5_flags",
             .sheet = "flag",
             .area = 0.54,
             .steps = {1e-3, 2e-3, 4e-3, 1e-2, 2e-2},
             .begin = 0.3,
             .settings = {"force.wind.ramp=0"}},
            {.name = "cylinder",
             .scene = "paper/figure_3_cylinders",
             .sheet = "cylinder",
             .area = 0.157,
             .steps = {1e-4, 2e-4, 5e-4, 1e-3, 2e-3},
             .begin = 0.03,
             .settings = {}},
            {.name = "bowl",
             .scene = "paper/figure_7_bowls",
             .sheet = "bowl",
             .area = 0.0184,
             .steps = {3e-5, 6e-5, 1.2e-4, 2.5e-4, 5e-4},
             .begin = 0.0015,
             .settings = {"sheet.bowl.fracture.strain=1e9"}}};
}

std::vector<PaperCase> paper_cases(bool quick, double most_vertices) {
    const int side = quick ? 20 : 40, laps = quick ? 3 : 5;
    std::vector<PaperCase> cases;
    for (const PaperScene& scene : paper_scenes()) {
        for (std::size_t i = 0; i < scene.steps.size(); i += quick ? 2 : 1)
            cases.push_back({scene, scene.steps[i], side, laps});
        for (const int other : quick ? std::vector{10} : std::vector{10, 20, 80, 160})
            cases.push_back({scene, scene.steps[middle], other, laps});
    }
    std::erase_if(cases, [=](const PaperCase& one) { return one.side * one.side > most_vertices; });
    return cases;
}

std::vector<PaperResult> run_paper_case(const PaperCase& one, const std::vector<SolverChoice>& choices) {
    SolverChoice fast = choices.front();
    fast.settings.push_back("solver.method=quasi-newton");  // the last setting of a key counts
    MeasuredRun before(scene_of(one, fast, one.scene.steps.back()));
    before.advance_to(one.scene.begin);
    const ShellMotion start = before.motion();
    std::vector<PaperResult> results(choices.size());
    for (const std::vector<std::size_t>& group : groups_of(choices)) {
        std::vector<Scene> scenes;
        for (const std::size_t i : group) scenes.push_back(scene_of(one, choices[i], one.step));
        std::vector<RaceResult> raced =
            race(scenes, {.step = one.step, .laps = one.laps, .allowance = 3}, start);
        const RaceResult beside = raced.front();
        for (std::size_t k = 0; k < group.size(); ++k) {
            PaperResult& result = results[group[k]];
            if (k == 0 && result.ratio > 0) continue;  // keeps the result of its first group
            result.race = std::move(raced[k]);
            if (result.race.failure.empty() && beside.failure.empty())
                result.ratio = result.race.cost().rate() / beside.cost().rate();
            const auto first =
                std::ranges::find(choices, choices[group[k]].energies, &SolverChoice::energies);
            result.difference =
                difference(result.race, results[first - choices.begin()].race, edge_length(one));
        }
    }
    return results;
}

}  // namespace sherd
