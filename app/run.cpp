// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "app/commands.h"
#include "app/progress/interruption.h"
#include "app/progress/progress_observer.h"
#include "app/run/run_recorder.h"
#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/run_summary.h"
#include "app/run_variants.h"
#include "app/scene/build/built_scene.h"
#include "app/time_table.h"
#include "app/words/moment_words.h"

namespace sherd {
namespace {

/// Ctrl-C and SIGTERM end the run after the step that is going on.
class EndOnInterruption : public RunObserver {
  public:
    explicit EndOnInterruption(bool is_part) {
        watch_for_interruption();
        if (is_part) leave_interruption_to_parent();
    }
    bool wants_end() const override { return interrupted(); }
};

int run(const Scene& scene, const std::filesystem::path& file, const RunOptions& options) {
    RecordingOutput output(file, options.force);
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "sherd: warning: {}\n", warning);
    Runner runner(scene, std::move(built));
    const Simulation& simulation = runner.simulation();
    EndOnInterruption interruption(options.progress_to >= 0);
    RunRecorder recorder(std::move(output), scene, simulation);
    RunTotals totals;
    ProgressObserver progress(scene.duration, scene.time_unit(), totals, options.progress_to);
    for (RunObserver* observer :
         std::initializer_list<RunObserver*>{&interruption, &totals, &progress, &recorder})
        runner.add(*observer);

    const RunEnd end = runner.run();
    fmt::print("{}", run_summary(totals, end, file, scene, simulation));
    std::fflush(stdout);  // before what goes to stderr
    fmt::print(stderr, "{}", time_table(simulation.time_spent(), recorder.seconds(), end.wall_seconds));
    if (end.is_complete()) return 0;
    fmt::print(stderr, "sherd: interrupted; '{}' has the run up to {}\n", file.string(),
               moment_words(fmt::format("{:g}", simulation.time()), scene.time_unit()));
    return interruption_exit_code();
}

int run(const RunOptions& options) {
    const std::vector<Scene> scenes = read_scenes(options.scene);
    const Scene& first = scenes.front();
    if (options.scene.choice.variant.empty() && !first.variant.empty()) return run_variants(scenes, options);
    return run(first, options.output.empty() ? recording_name(first) : options.output, options);
}

}  // namespace

void add_run(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("run", "Simulate a scene and record it");
    auto options = std::make_shared<RunOptions>();
    add_scene_options(*command, options->scene);
    command->add_option("-o,--output", options->output,
                        "Recording to write (.h5); an .xdmf for ParaView goes beside it. Default: the "
                        "scene's name. Of all variants: NAME.h5 becomes NAME-VARIANT.h5 for each; anything "
                        "else is a folder for them");
    command->add_flag("--force", options->force, "Replace a recording that exists");
    command->add_option("-j,--jobs", options->jobs, "How many variants to run at a time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--progress-to", options->progress_to, "Descriptor for reports to this program")
        ->group("");  // not for people, and not shown to them
    command->footer("Example:\n  sherd run plate_drop -o plate.h5 --set duration=0.02");
    command->callback([&chosen, options] { chosen = [options] { return run(*options); }; });
}

}  // namespace sherd
