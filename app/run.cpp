// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "app/commands.h"
#include "app/interruption.h"
#include "app/progress/run_reporter.h"
#include "app/recording/obstacle_track.h"
#include "app/run_variants.h"
#include "app/scene/scene_simulation.h"
#include "app/scene/sheet_parting.h"
#include "app/time_table.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// What the run adds up over its steps.
struct Totals {
    std::size_t cracks = 0, capped = 0;
    std::int64_t newton_iterations = 0, halvings = 0;
    double smallest_step = std::numeric_limits<double>::infinity();
    StepReport peaks;
    StepReport last;
};

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
    Totals totals;
    std::vector<StepReport> unrecorded;
    CrackEvents unrecorded_events;
};

void Runner::step() {
    const StepReport report = simulation.step();
    CrackEvents events = simulation.take_events();
    totals.cracks += events.failures.size();
    totals.halvings += report.halvings;
    totals.smallest_step = std::min(totals.smallest_step, report.step_size);
    totals.capped += report.stage_cap_reached;
    totals.newton_iterations += report.newton_iterations;
    raise_peaks(totals.peaks, report);
    totals.last = report;
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
    const auto frame_of = [this](std::int64_t step) {
        return std::floor(static_cast<double>(step) * scene.solver.step / scene.frame_interval + 1e-6);
    };
    record();
    for (std::int64_t i = 1; i <= steps && !interrupted(); ++i) {
        while (simulation.time() < static_cast<double>(i) * scene.solver.step && !interrupted()) step();
        if (frame_of(i) > frame_of(i - 1) || i == steps || interrupted()) record();
    }
    progress.finish();
    return simulation.time() == static_cast<double>(steps) * scene.solver.step ? "complete" : "interrupted";
}

void Runner::print_summary(const std::string& end, const std::filesystem::path& output) const {
    const auto row = [](const char* name, const std::string& value) {
        fmt::print("{:<22}{}\n", name, value);
    };
    row("run", end);
    row("recording", output.string());
    row("steps", fmt::format("{} of {:g} s", totals.last.step, scene.solver.step));
    row("simulated time", fmt::format("{:g} s", totals.last.time));
    row("wall time", fmt::format("{:.1f} s", wall_seconds()));
    row("Newton iterations",
        fmt::format("{} ({:.2f} a step)", totals.newton_iterations,
                    static_cast<double>(totals.newton_iterations) /
                        static_cast<double>(std::max<std::int64_t>(1, totals.last.step))));
    row("cracked edges", fmt::format("{}", totals.cracks));
    row("fragments", fmt::format("{}", totals.last.fragments));
    row("peak strain", fmt::format("{:.4g} 1/m (of bending alone: {:.4g} 1/m)", totals.peaks.peak_strain,
                                   totals.peaks.peak_bending_strain));
    row("peak stress", fmt::format("{:.4g} Pa", totals.peaks.peak_stress));
    if (totals.peaks.peak_overload > 0)
        row("peak overload", fmt::format("{:.4g} times the strength", totals.peaks.peak_overload));
    if (totals.cracks == 0) row("", "no hinge broke; to break it, try half of a peak as its strength");
    if (totals.halvings > 0)
        row("steps halved", fmt::format("{} times, down to {:g} s", totals.halvings, totals.smallest_step));
    if (totals.capped > 0) row("steps out of stages", fmt::format("{}", totals.capped));
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
    const ObstacleTrack obstacles(scene, simulated.obstacles, simulated.bodies);
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
