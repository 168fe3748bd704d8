// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/modes/modes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/messages/print.h"
#include "app/progress/interruption.h"
#include "app/scene/assemble/built_scene.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The command line of `sherd modes`.
struct ModesOptions {
    SceneOptions scene;
    int count = 12;
    std::filesystem::path output;  ///< empty: no recording
    ModeFrames frames;
    bool json = false, force = false;
};

std::vector<std::string> left_out_of_modes(const Scene& scene) {
    std::vector<std::string> touched, all;
    for (const std::vector<ObstacleSpec>* some : {&scene.obstacles, &scene.bodies})
        for (const ObstacleSpec& obstacle : *some) touched.push_back(obstacle.name);
    if (!touched.empty()) all.push_back(fmt::format("contact with {}", fmt::join(touched, ", ")));
    if (scene.sheets.size() > 1) all.emplace_back("contact of the sheets with each other");
    if (!scene.winds.empty()) all.emplace_back("wind");
    if (scene.simulation.stepper.shell.damping.stiffness > 0 ||
        scene.simulation.stepper.shell.damping.mass > 0)
        all.emplace_back("damping");
    return all;
}

void warn_of_modes(const Scene& scene, const SceneModes& modes) {
    const auto warn = [](const std::string& words) { print_message("sherd: warning: {}\n", words); };
    if (scene.simulation.stepper.shell.bending.model == BendingModel::cubic_2007)
        warn(
            "with bending = \"cubic-2007\" curved sheets are not in equilibrium at the start: these are "
            "modes about a shape that is not at rest");
    if (modes.vibration.modes.front().unstable())
        warn(
            "the initial state of the scene is unstable: modes that the table marks as unstable grow instead "
            "of vibrating");
}

/// Prints and records the modes of one scene or variant. Returns false after an interruption.
bool print_modes(const Scene& scene, const ModesOptions& options, Json& json) {
    std::optional<RecordingOutput> output;
    if (!options.output.empty()) {
        const std::filesystem::path file = part_file(options.output, scene.variant);
        require_no_input(file, scene);
        output.emplace(file, options.force);
    }
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    print_warnings(warnings);
    const Simulation simulation(std::move(built.sheets), built.options);
    const SceneModes modes = scene_modes(scene, simulation, built.options.stepper.shell, options.count);
    if (options.json)
        json.push_back(modes_json(scene, modes));
    else
        print_result("{}", modes_text(scene, modes));
    warn_of_modes(scene, modes);
    if (!output) return true;
    const std::filesystem::path file = output->recording.output();
    const bool complete = record_modes(std::move(*output), scene, simulation, modes, options.frames);
    if (!options.json && complete)
        print_result("recording    {}: mode i from i - 1 to i s, largest in frame {} (i - 1) + {}\n",
                     file.string(), options.frames.a_mode, options.frames.a_mode / 4);
    return complete;
}

int print_all_modes(const ModesOptions& options) {
    const std::vector<Scene> scenes = read_scenes(options.scene);
    if (!options.output.empty())  // check all outputs before the first computation
        for (const Scene& scene : scenes)
            const RecordingOutput free(part_file(options.output, scene.variant), options.force);
    Json json = Json::array();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        if (i > 0 && !options.json) print_result("\n");
        if (!print_modes(scenes[i], options, json)) {
            print_message("sherd: interrupted; the recording has the frames up to this point\n");
            return interruption_exit_code();
        }
    }
    const bool several = options.scene.choice.variant.empty() && !scenes.front().variant.empty();
    if (options.json)  // at the end, since the output is one JSON value
        print_result("{}\n",
                     (several ? json : json.front()).dump(2, ' ', false, Json::error_handler_t::replace));
    return 0;
}

}  // namespace

SceneModes scene_modes(const Scene& scene, const Simulation& simulation, const ShellEnergyOptions& energies,
                       Index count) {
    const Shell& shell = simulation.shell().mechanics();
    SceneModes modes;
    modes.vertices = shell.mass.size();
    modes.faces = shell.triangles.size();
    modes.left_out = left_out_of_modes(scene);
    modes.vibration = vibration(shell, energies, count);
    if (modes.vibration.modes.empty())
        throw Error(fmt::format(
            "{}: nothing can vibrate: pins, clamps and symmetry planes leave {} of {} coordinates free, {} "
            "of them for rigid motions; hold fewer vertices",
            scene.file.string(), modes.vibration.freedoms, 3 * modes.vertices, modes.vibration.rigid));
    for (const VibrationMode& mode : modes.vibration.modes)
        modes.out_of_plane.push_back(share_along_normals(shell, shell.position, mode.shape));
    return modes;
}

void add_modes(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand(
        "modes", "Compute natural frequencies and mode shapes of a scene's sheets in their initial state");
    auto options = std::make_shared<ModesOptions>();
    add_scene_options(*command, options->scene);
    command
        ->add_option("-n,--count", options->count,
                     "Number of modes, from the lowest frequency up (default 12)")
        ->check(whole_number(1, 1000))
        ->option_text("N");
    command
        ->add_option("-o,--output", options->output,
                     "Recording to write (.h5), which plays each mode for a second; for variants NAME.h5 "
                     "becomes NAME-VARIANT.h5")
        ->option_text("MODES.h5");
    command
        ->add_option("--amplitude", options->frames.amplitude,
                     "Largest displacement in the recording, as a share of the sheets' size (default 0.05)")
        ->check(number_within(1e-6, 10))
        ->option_text("SHARE");
    command
        ->add_option("--frames", options->frames.a_mode,
                     "Frames per mode in the recording, a multiple of 4 (default 24)")
        ->check(whole_number(4, 1000))
        ->check([](const std::string& given) {
            return std::stoi(given) % 4 == 0 ? std::string() : "is no multiple of 4: " + given;
        })
        ->option_text("N");
    command->add_flag("--json", options->json,
                      "For scripts: one JSON object, or an array of them for several variants");
    command->add_flag("--force", options->force, "Replace a recording that exists");
    command->footer("Example:\n  sherd modes sheet_hang -n 6 -o modes.h5");
    command->callback([&chosen, options] { chosen = [options] { return print_all_modes(*options); }; });
}

}  // namespace sherd
