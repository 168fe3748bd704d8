// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <utility>

#include "app/commands.h"
#include "app/files/pending_file.h"
#include "app/machine/threads.h"
#include "app/messages/print.h"
#include "app/messages/time_text.h"
#include "app/number_check.h"
#include "app/progress/interruption.h"
#include "app/progress/progress_observer.h"
#include "app/run/checkpoint_keeper.h"
#include "app/run/run_recorder.h"
#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/run_start.h"
#include "app/run_summary.h"
#include "app/run_variants.h"
#include "app/scene/build/built_scene.h"
#include "app/scene/build/squeeze.h"
#include "app/time_table.h"

namespace sherd {
namespace {

/// Ends the run after the current step on Ctrl-C or SIGTERM.
class EndOnInterruption : public RunObserver {
  public:
    explicit EndOnInterruption(bool is_part) {
        watch_for_interruption();
        if (is_part) leave_interruption_to_parent();
    }
    bool should_end() const override { return interrupted(); }
};

/// Ends a run at a simulated time, s.
class EndAt : public RunObserver {
  public:
    explicit EndAt(double time) : time(time) {}
    void stepped(const StepReport& report, const CrackEvents&) override { reached = has_come(report.time); }
    bool should_end() const override { return reached; }
    bool has_come(double now) const { return now >= time * (1 - rounding); }

  private:
    static constexpr double rounding = 1e-12;

    double time;
    bool reached = false;
};

Runner built_runner(const Scene& scene, int threads) {
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    built.options.stepper.threads = threads;
    warn_of_squeezes(scene, built, warnings);
    print_warnings(warnings);
    return Runner(scene, std::move(built));
}

/// The scene with which a run is resumed: with the frame interval of the checkpoint, unless it is set
/// explicitly.
Scene scene_from(Scene scene, const std::optional<Checkpoint>& checkpoint) {
    if (checkpoint && !scene.settings.contains("output.every"))
        scene.frame_interval = checkpoint->frame_interval;
    return scene;
}

void report_nothing_left(const std::filesystem::path& file, double time, const std::string& unit) {
    print_message("sherd: '{}' has reached {:g} {}: nothing is left to do\n", file.string(), time, unit);
}

/// Reports that a run is resumed, and prepares its recording; or reports that nothing is left to do. Returns
/// whether the run is resumed.
bool goes_on(const std::filesystem::path& file, const Runner& runner, const EndAt& end,
             RunRecorder& recorder) {
    const double now = runner.simulation().time();
    const std::string unit = runner.scene().time_unit();
    const bool all = runner.is_complete() && Recording(file).end() == "complete";
    if (all || end.has_come(now)) {
        report_nothing_left(file, now, unit);
        return false;
    }
    print_message("sherd: '{}' is resumed at {:g} {}\n", file.string(), now, unit);
    recorder.resume(runner.scene());
    return true;
}

int run(const Scene& scene, const std::filesystem::path& file, const RunOptions& options) {
    require_no_input(file, scene);
    RunStart start = run_start(file, options);
    Runner runner = built_runner(scene_from(scene, start.checkpoint), threads_of_run(options.threads, 1));
    if (start.is_finished) {
        require_whole(file, runner.scene(), runner.end_time());
        report_nothing_left(file, runner.end_time(), scene.time_unit());
        return 0;
    }
    const Simulation& simulation = runner.simulation();
    EndOnInterruption interruption(options.progress_to >= 0);
    EndAt end_at(options.until);
    RunTotals totals;
    RunRecorder recorder(std::move(start.output), runner.scene(), simulation, start.checkpoint.has_value());
    CheckpointKeeper keeper({runner, totals, recorder}, run_origin(runner));
    if (start.checkpoint) {
        keeper.restore(*start.checkpoint);
        if (!goes_on(file, runner, end_at, recorder)) return 0;
    }
    ProgressObserver progress(scene, simulation.time(), totals, options.progress_to);
    for (RunObserver* observer :
         std::initializer_list<RunObserver*>{&interruption, &end_at, &totals, &progress, &recorder, &keeper})
        runner.add(*observer);

    const double seconds_before = runner.wall_seconds();
    const RunEnd end = runner.run();
    print_result("{}", run_summary(totals, end, file, scene, simulation));
    print_message("{}", time_table(simulation.time_spent(), recorder.seconds() + keeper.seconds(),
                                   end.wall_seconds - seconds_before));
    if (end.is_complete() || end_at.has_come(simulation.time())) return 0;
    print_message("sherd: interrupted; '{}' has the run up to {}; --resume continues it\n", file.string(),
                  time_text(fmt::format("{:g}", simulation.time()), scene.time_unit()));
    return interruption_exit_code();
}

int run(const RunOptions& options) {
    require_kind(options.output, ".h5",
                 "a recording is HDF5; name a .h5 file, from which sherd export makes other formats");
    const std::vector<Scene> scenes = read_scenes(options.scene);
    const Scene& first = scenes.front();
    if (options.scene.choice.variant.empty() && !first.variant.empty() &&
        std::filesystem::is_fifo(options.scene.file))
        throw Error(
            fmt::format("{}: has variants, and each is run by a process of its own, which reads the scene "
                        "again: give a file, or --variant NAME",
                        options.scene.file.string()));
    if (options.scene.choice.variant.empty() && !first.variant.empty()) return run_variants(scenes, options);
    return run(first, options.output.empty() ? recording_name(first) : options.output, options);
}

}  // namespace

void add_run(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("run", "Simulate a scene and record it");
    auto options = std::make_shared<RunOptions>();
    add_scene_options(*command, options->scene);
    command->add_option("-o,--output", options->output,
                        "Recording to write (.h5); an .xdmf for ParaView is written beside it. Default: the "
                        "scene's name. With several variants NAME.h5 becomes NAME-VARIANT.h5 for each; any "
                        "other name is a folder for them");
    command->add_flag("--force", options->force, "Replace a recording that exists");
    command->add_flag("--resume", options->resume,
                      "Continue from the last checkpoint; only duration may differ");
    command
        ->add_option("--until", options->until, "End at this simulated time; --resume continues from there")
        ->check(positive_number())
        ->option_text("TIME");
    command
        ->add_option("--threads", options->threads,
                     "Largest number of threads; results do not depend on it. Default: as many as the "
                     "processor runs at once, up to 4")
        ->check(whole_number(1))
        ->option_text("N");
    command->add_option("-j,--jobs", options->jobs, "Number of variants to run at a time")
        ->check(whole_number(1))
        ->capture_default_str();
    command->add_option("--progress-to", options->progress_to, "Descriptor for reports to this program")
        ->group("");  // internal, so not in the help
    command->footer("Example:\n  sherd run plate_drop -o plate.h5 --set duration=0.02");
    command->callback([&chosen, options] { chosen = [options] { return run(*options); }; });
}

}  // namespace sherd
