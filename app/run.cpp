// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "app/progress/interruption.h"
#include "app/progress/run_reporter.h"
#include "app/run/obstacle_track.h"
#include "app/run/recording_header.h"
#include "app/run_summary.h"
#include "app/run_variants.h"
#include "app/scene/build/scene_simulation.h"
#include "app/scene/build/sheet_parting.h"
#include "app/time_table.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Steps the simulation to its end and records it.
class Runner {
  public:
    Runner(const Scene& scene, const ObstacleTrack& obstacles, Simulation& simulation,
           RecordingWriter& writer, int progress_to)
        : scene(scene),
          obstacles(obstacles),
          simulation(simulation),
          writer(writer),
          progress(scene.duration, progress_to) {}

    /// Returns how the run ended: "complete" or "interrupted".
    std::string run();
    void print_summary(const std::string& end, const std::filesystem::path& output) const;
    void print_time_spent() const;
    double wall_seconds() const { return progress.wall_seconds(); }

  private:
    void step();
    void record();

    const Scene& scene;
    const ObstacleTrack& obstacles;
    Simulation& simulation;
    RecordingWriter& writer;
    RunReporter progress;
    double recording = 0;  ///< s, of wall time
    RunTotals totals;
    std::vector<StepReport> unrecorded;
    CrackEvents unrecorded_events;
};

void Runner::step() {
    const StepReport report = simulation.step();
    CrackEvents events = simulation.take_events();
    totals.add(report, events);
    unrecorded.push_back(report);
    append(unrecorded_events, events);
    progress.update({report.step, report.time, scene.duration, report.step_size,
                     static_cast<std::int64_t>(totals.cracks), report.fragments, totals.halvings});
}

void Runner::record() {
    const double start = wall_seconds();
    writer.append(simulation.snapshot(), unrecorded, unrecorded_events, obstacles.poses(simulation));
    unrecorded.clear();
    unrecorded_events = {};
    recording += wall_seconds() - start;
}

std::string Runner::run() {
    const std::int64_t steps = step_count(scene);
    record();
    for (std::int64_t i = 1; i <= steps && !interrupted(); ++i) {
        while (simulation.time() < static_cast<double>(i) * scene.solver.step && !interrupted()) step();
        if (has_frame(scene, i) || interrupted()) record();
    }
    progress.finish();
    return simulation.time() == static_cast<double>(steps) * scene.solver.step ? "complete" : "interrupted";
}

void Runner::print_summary(const std::string& end, const std::filesystem::path& output) const {
    fmt::print("{}", run_summary(totals, {end, output, wall_seconds()}, scene, simulation));
}

void Runner::print_time_spent() const {
    std::fflush(stdout);  // the summary comes first
    fmt::print(stderr, "{}", time_table(simulation.time_spent(), recording, wall_seconds()));
}

void warn(const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) fmt::print(stderr, "sherd: warning: {}\n", warning);
}

int run(const Scene& scene, const std::filesystem::path& file, const RunOptions& options) {
    RecordingOutput output(file, options.force);
    std::vector<std::string> warnings;
    std::vector<SheetInput> sheets;
    for (const SheetSpec& sheet : scene.sheets) sheets.push_back(make_sheet(sheet, scene, warnings));
    part_sheets(scene, sheets, warnings);
    const SimulationOptions simulated = simulation_options(scene, sheets, warnings);
    warn(warnings);
    Simulation simulation(sheets, simulated);
    const ObstacleTrack obstacles(scene, simulated.stepper.contact.obstacles,
                                  simulated.stepper.contact.bodies);
    watch_for_interruption();
    RecordingWriter writer(std::move(output), recording_header(scene, simulation), obstacles.obstacles());

    Runner runner(scene, obstacles, simulation, writer, options.progress_to);
    try {
        const std::string end = runner.run();
        writer.finish(runner.wall_seconds(), end);
        runner.print_summary(end, file);
        runner.print_time_spent();
        return end == "complete" ? 0 : 1;
    } catch (const std::exception& error) {
        writer.finish(runner.wall_seconds(), std::string("failed: ") + error.what());
        throw;
    }
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
