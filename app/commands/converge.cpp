// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/commands/commands.h"
#include "app/converge/observed_order.h"
#include "app/converge/run_results.h"
#include "app/json/json.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/scene/scene.h"
#include "meshops/error.h"

namespace sherd {
namespace {

struct ConvergeOptions {
    SceneOptions scene;
    bool json = false;
};

/// Outcomes of three runs, with edges or steps (`of`) 4 times, twice and once as long as in the scene.
struct Series {
    std::string of;
    std::array<RunResults, 3> runs;

    Convergence at(std::size_t quantity) const {
        return convergence({runs[0].quantities[quantity].value, runs[1].quantities[quantity].value,
                            runs[2].quantities[quantity].value});
    }
    /// Number of quantities that all runs have: the last one, a limit load, may be missing in some.
    std::size_t quantities() const {
        return std::min({runs[0].quantities.size(), runs[1].quantities.size(), runs[2].quantities.size()});
    }
    bool breaks() const { return runs[0].cracks + runs[1].cracks + runs[2].cracks > 0; }
};

RunResults told(const Scene& scene, const char* what) {
    print_message("{}: ", what);
    RunResults result = results_of(scene);
    print_message("{}, {} of {:g}, {}, {:.1f} s\n", counted(result.faces, "face"),
                  counted(result.steps, "step"), scene.simulation.stepper.step,
                  counted(result.cracks, "crack"), result.seconds);
    return result;
}

std::string cell(const std::optional<double>& value, const char* format, double factor = 1) {
    return value ? fmt::format(fmt::runtime(format), factor * *value) : "-";
}

std::string name_of(const Quantity& quantity) {
    return quantity.unit.empty() ? quantity.name : fmt::format("{}, {}", quantity.name, quantity.unit);
}

std::string text_of(const Series& series) {
    std::size_t width = 0;
    for (const Quantity& quantity : series.runs[2].quantities)
        width = std::max(width, name_of(quantity).size());
    std::string text = fmt::format("\n{}\n{:<{}} {:>12} {:>12} {:>12} {:>6} {:>12} {:>9}\n", series.of, "",
                                   width, "4 times", "twice", "as it is", "order", "limit", "error");
    for (std::size_t q = 0; q < series.quantities(); ++q) {
        const Convergence found = series.at(q);
        text += fmt::format("{:<{}} {:>12.6g} {:>12.6g} {:>12.6g} {:>6} {:>12} {:>9}\n",
                            name_of(series.runs[2].quantities[q]), width, found.values[0], found.values[1],
                            found.values[2], cell(found.order, "{:.2f}"), cell(found.limit, "{:.6g}"),
                            cell(found.error, "{:+.2f} %", 100));
    }
    if (series.breaks())
        text += "The scene breaks: results after the first crack depend on the mesh and on the step.\n";
    return text;
}

Json json_of(const Series& series) {
    Json rows = Json::array();
    for (std::size_t q = 0; q < series.quantities(); ++q) {
        const Convergence found = series.at(q);
        Json row{{"name", series.runs[2].quantities[q].name},
                 {"unit", series.runs[2].quantities[q].unit},
                 {"values", found.values},
                 {"order", nullptr},
                 {"limit", nullptr},
                 {"error", nullptr}};
        if (found.order) row["order"] = *found.order;
        if (found.limit) row["limit"] = *found.limit;
        if (found.error) row["error"] = *found.error;
        rows.push_back(row);
    }
    Json faces = Json::array(), steps = Json::array(), cracks = Json::array();
    for (const RunResults& run : series.runs) {
        faces.push_back(run.faces);
        steps.push_back(run.steps);
        cracks.push_back(run.cracks);
    }
    return {{"faces", faces}, {"steps", steps}, {"cracks", cracks}, {"quantities", rows}};
}

int converge(const ConvergeOptions& options) {
    const std::vector<Scene> scenes = read_scenes(options.scene);
    if (scenes.size() > 1)
        throw Error(fmt::format("{} has variants: choose one with --variant", scenes[0].file.string()));
    const Scene& scene = scenes.front();
    const Scene coarse = with_edges(scene, 4), middle = with_edges(scene, 2);
    const Scene longest = with_steps(scene, 4), longer = with_steps(scene, 2);
    Series meshes{"edges", {told(coarse, "edges 4 times as long"), told(middle, "edges twice as long"), {}}};
    Series steps{"steps", {told(longest, "steps 4 times as long"), told(longer, "steps twice as long"), {}}};
    meshes.runs[2] = steps.runs[2] = told(scene, "as it is");
    if (options.json)
        print_result("{}\n", Json{{"edges", json_of(meshes)}, {"steps", json_of(steps)}}.dump(2));
    else
        print_result("{}{}", text_of(meshes), text_of(steps));
    return 0;
}

}  // namespace

void add_converge(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "converge", "Estimate the errors of a scene's results that come from its mesh and its steps");
    auto options = std::make_shared<ConvergeOptions>();
    add_scene_options(*command, options->scene);
    command->add_flag("--json", options->json, "For scripts: one JSON object");
    command->footer("Example:\n  sherd converge hinged_roof --variant thick");
    command->callback([&chosen, options] { chosen = [options] { return converge(*options); }; });
}

}  // namespace sherd
