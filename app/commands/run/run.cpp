// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/commands/run/peak_table.h"
#include "app/commands/run/run_variants.h"
#include "app/files/disk/pending_file.h"
#include "app/machine/threads.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/messages/time_text.h"
#include "app/progress/interruption.h"
#include "app/progress/progress_observer.h"
#include "app/recording/recording.h"
#include "app/run/checkpoint.h"
#include "app/run/checkpoint_keeper.h"
#include "app/run/run_observer.h"
#include "app/run/run_recorder.h"
#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/crack_step_message.h"
#include "app/scene/assemble/check/squeeze.h"
#include "app/scene/assemble/yield_message.h"
#include "app/scene/scene.h"
#include "core/time_spent.h"
#include "fracture/step/simulation.h"
#include "meshops/error.h"

namespace sherd {
namespace {

void add_row(std::string& text, const char* name, const std::string& value) {
    text += fmt::format("{:<22}{}\n", name, value);
}

void add_peaks(std::string& text, const RunTotals& totals) {
    add_row(text, "peak strain",
            fmt::format("{:.4g} 1/m (of bending alone: {:.4g} 1/m)", totals.peaks.peak_strain,
                        totals.peaks.peak_bending_strain));
    add_row(text, "peak stress", fmt::format("{:.4g} Pa", totals.peaks.peak_stress));
    if (totals.peaks.peak_overload > 0)
        add_row(text, "peak overload", fmt::format("{:.4g} times the strength", totals.peaks.peak_overload));
}

void add_yield(std::string& text, const RunTotals& totals, const Scene& scene) {
    const StepReport& peaks = totals.peaks;
    if (!(peaks.peak_yield > 0)) return;
    add_row(text, "peak yield", yield_message(peaks.peak_yield, peaks.yielding, scene));
    if (!std::isfinite(totals.yielded_at)) return;
    const bool keeps = bends_plastically(scene, scene.sheets[peaks.yielding.sheet]);
    add_row(
        text, keeps ? "keeps a dent" : "would keep a dent",
        fmt::format("from {} on{}", time_text(fmt::format("{:.4g}", totals.yielded_at), scene.time_unit()),
                    keeps ? "" : "; here it springs back"));
}

/// Number and size of the steps, "20 of at most 0.001 s": steps that were halved or cut are shorter than
/// those of the scene.
std::string step_words(const RunTotals& totals, const Scene& scene, const char* unit) {
    constexpr double rounding = 1e-9;
    const double whole = static_cast<double>(totals.last.step) * scene.simulation.stepper.step;
    const bool is_cut = !scene.is_static() && totals.last.time < whole * (1 - rounding);
    return fmt::format("{} of {}{:g}{}", totals.last.step, is_cut ? "at most " : "",
                       scene.simulation.stepper.step, unit);
}

std::string load_words(const LoadHistory& load) {
    std::string words = fmt::format("{:.6g} at the end", load.last);
    if (load.limit) words += fmt::format(", fell for the first time at {:.6g}", *load.limit);
    return words;
}

/// Simulated duration, number and causes of the phases of explicit steps between implicit steps, and number
/// of times that explicit steps failed.
std::string explicit_words(const RunTotals& totals) {
    constexpr std::array<std::pair<Urgency, const char*>, 5> names{{{Urgency::strike, "strikes"},
                                                                    {Urgency::stress, "stress"},
                                                                    {Urgency::crack, "cracks"},
                                                                    {Urgency::unsolved, "unsolved steps"},
                                                                    {Urgency::passage, "passages"}}};
    std::vector<std::string> causes;
    for (const auto& [urgency, name] : names)
        if (const auto times = totals.urgencies[static_cast<std::size_t>(urgency)]; times > 0)
            causes.push_back(fmt::format("{} {}", name, times));
    std::string words = fmt::format("{:g} s of simulated time", totals.explicit_time);
    if (!causes.empty()) words += fmt::format("; started by: {}", fmt::join(causes, ", "));
    if (const auto times = totals.urgencies[static_cast<std::size_t>(Urgency::explicit_failed)]; times > 0)
        words += fmt::format("; {} they failed, and implicit steps continued",
                             times == 1 ? "once" : counted(times, "time"));
    return words;
}

/// Adds a row if the time scheme has increased the energy much: a suitable scheme only dissipates energy.
void add_made_energy(std::string& text, const RunTotals& totals, const Scene& scene) {
    constexpr double much = 0.1;  // share of the largest energy
    const double made = -totals.last.lost_to_scheme;
    if (!scene.is_static() && made > much * totals.largest_energy)
        add_row(text, "energy gained",
                fmt::format("{:.3g} J, an error of the time scheme; the largest energy is {:.3g} J: use "
                            "shorter steps, or another solver.scheme",
                            made, totals.largest_energy));
}

std::vector<std::string> untouched_obstacles(const Scene& scene, const Simulation& simulation) {
    std::vector<std::string> names;
    for (std::size_t o = 0; o < scene.obstacles.size(); ++o)
        if (!simulation.touched_obstacles()[o]) names.push_back(scene.obstacles[o].name);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (!simulation.touched_bodies()[b]) names.push_back(scene.bodies[b].name);
    return names;
}

/// The table that is printed at the end of a run. It includes the peaks of the hinges if nothing failed, and
/// the names of obstacles that nothing touched.
std::string run_summary(const RunTotals& totals, const RunEnd& end, const std::filesystem::path& recording,
                        const Scene& scene, const Simulation& simulation) {
    std::string text;
    add_row(text, "run", end.how);
    add_row(text, "recording", recording.string());
    const char* unit = scene.is_static() ? "" : " s";
    add_row(text, "steps", step_words(totals, scene, unit));
    if (scene.is_static())
        add_row(text, "load", load_words(totals.load));
    else
        add_row(text, "simulated time", fmt::format("{:g} s", totals.last.time));
    add_row(text, "wall time", fmt::format("{:.1f} s", end.wall_seconds));
    if (scene.simulation.alternates) add_row(text, "explicit steps", explicit_words(totals));
    add_row(text,
            scene.simulation.stepper.scheme == Scheme::explicit_differences ? "parts of substeps"
                                                                            : "Newton iterations",
            fmt::format("{} ({:.2f} a step)", totals.newton_iterations,
                        static_cast<double>(totals.newton_iterations) /
                            static_cast<double>(std::max<std::int64_t>(1, totals.last.step))));
    add_row(text, "cracked edges", fmt::format("{}", totals.cracks));
    if (const auto words = crack_step_message(scene, simulation.shell());
        simulation.grown_edges() > 0 && !words.empty())
        add_row(text, "cracks run", words);
    add_row(text, "fragments", fmt::format("{}", totals.last.fragments));
    add_peaks(text, totals);
    add_yield(text, totals, scene);
    if (totals.halvings > 0)
        add_row(
            text, "steps halved",
            fmt::format("{}, down to {:g}{}", counted(totals.halvings, "time"), totals.smallest_step, unit));
    if (simulation.prevented_failures() > 0)
        add_row(text, "failures forbidden",
                fmt::format("{}, which would have made pieces below fracture.smallest",
                            simulation.prevented_failures()));
    if (totals.capped > 0) add_row(text, "steps at stage limit", fmt::format("{}", totals.capped));
    add_made_energy(text, totals, scene);
    if (totals.cracks == 0 && totals.last.step > 0) text += peak_table(peak_rows(scene, simulation));
    if (const auto names = untouched_obstacles(scene, simulation); !names.empty())
        add_row(text, "nothing touched", fmt::format("obstacle.{}", fmt::join(names, ", obstacle.")));
    return text;
}

/// The start of a run.
struct RunStart {
    RecordingOutput output;
    std::optional<Checkpoint> checkpoint;  ///< none: the run starts at its beginning
    bool is_finished = false;              ///< whether the recording is complete, and has no checkpoint
};

std::optional<Checkpoint> read_last(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    std::optional<Checkpoint> last = last_checkpoint(file, warnings);
    print_warnings(warnings);
    if (last && !std::filesystem::exists(file))
        throw Error(
            fmt::format("there are checkpoints of '{}', but not the recording itself: restore it, or pass "
                        "--force instead of --resume to start again",
                        file.string()));
    return last;
}

/// Finds the start of a run that is recorded in `file`. If there is no recording to resume, or a recording
/// without a frame, the run starts at its beginning; with --resume, a message says so. With --resume, throws
/// Error (input) on an incomplete recording without a checkpoint, and on a checkpoint without its recording.
RunStart run_start(const std::filesystem::path& file, const RunOptions& options) {
    RunStart start{RecordingOutput(file, options.force || options.resume), {}};
    if (options.resume) start.checkpoint = read_last(file);
    if (start.checkpoint) return start;
    const bool is_there = std::filesystem::exists(file);
    if (options.resume && is_there && !options.force && Recording(file).frame_count() > 0) {
        start.is_finished = Recording(file).end() == "complete";
        if (start.is_finished) return start;
        throw Error(
            fmt::format("'{}' has no checkpoint to resume from; pass --force to start again", file.string()));
    }
    if (options.resume)
        print_message("sherd: '{}' has not been started: the run starts from the beginning\n", file.string());
    remove_checkpoints(file);
    return start;
}

/// Throws Error (input) unless the complete recording in `file` is of this scene and covers the whole run,
/// which ends at `end_time`.
void require_whole(const std::filesystem::path& file, const Scene& scene, double end_time) {
    constexpr double rounding = 1e-12;
    const Recording recording(file);
    const std::vector<StepReport> steps = recording.steps();
    const double time = steps.empty() ? 0 : steps.back().time;
    if (!scene.is_static() && time > end_time * (1 + rounding))
        throw Error(fmt::format("the run has reached {:g} s, past duration = {:g}; give a longer duration",
                                time, scene.duration));
    if (!scene.is_static() && time < end_time * (1 - rounding))
        throw Error(
            fmt::format("'{}' is complete at {:g} s, and has no checkpoint from which it could be continued "
                        "(none is written before the first output.checkpoint); --force instead of --resume "
                        "runs it from the beginning",
                        file.string(), time));
    if (recording.header().scene_text != scene.text)
        throw Error(
            fmt::format("'{}' is complete, but its scene had another text or other --set, or these in "
                        "another order; --force instead of --resume starts again",
                        file.string()));
}

/// Table of the wall time of a run by task, in s and as a share of the whole time. recording: s, time spent
/// on writing the recording; whole: s, time of the run.
std::string time_table(const TimeSpent& spent, double recording, double whole) {
    std::string table = fmt::format("{:<22}{:>10}{:>10}\n", "time spent on", "seconds", "share");
    const auto row = [&](const char* name, double seconds) {
        table += fmt::format("{:<22}{:>10.2f}{:>8.1f} %\n", name, seconds, 100 * seconds / whole);
    };
    const double solver = spent.on(Task::analysis) + spent.on(Task::factorization) + spent.on(Task::solution);
    const double known = spent.on(Task::elasticity) + spent.on(Task::contact) + spent.on(Task::loads) +
                         solver + spent.on(Task::breaking) + recording;
    row("elastic energies", spent.on(Task::elasticity));
    row("linear solver", solver);
    row("  analysis", spent.on(Task::analysis));
    row("  factorization", spent.on(Task::factorization));
    row("  solution", spent.on(Task::solution));
    row("contact", spent.on(Task::contact));
    row("loads, wind, damping", spent.on(Task::loads));
    row("breaking", spent.on(Task::breaking));
    row("recording", recording);
    row("rest", whole - known);
    return table;
}

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

/// The scene with which a run continues from a checkpoint: with the frame interval of the checkpoint, unless
/// the scene sets output.every.
Scene scene_from(Scene scene, const std::optional<Checkpoint>& checkpoint) {
    if (checkpoint && !scene.settings.contains("output.every"))
        scene.frame_interval = checkpoint->frame_interval;
    return scene;
}

/// A time of a run of this scene, with its unit.
std::string moment_words(double time, const Scene& scene) {
    return time_text(fmt::format("{:g}", time), scene.time_unit());
}

/// Reports that a complete run, which ended at `time`, is not continued.
void report_nothing_left(const std::filesystem::path& file, double time, const Scene& scene) {
    print_message("sherd: '{}' has reached {}: nothing is left to do\n", file.string(),
                  moment_words(time, scene));
}

/// Words about the frames that a killed run has recorded after its last checkpoint, which is at `time`; empty
/// if there are none. fate: what becomes of these frames.
std::string later_frame_words(const Recording& recording, double time, const Scene& scene, const char* fate) {
    const std::size_t count = recording.frame_count();
    if (count == 0 || recording.time(count - 1) <= time) return "";
    return fmt::format("; frames beyond it, up to {}, {}", moment_words(recording.time(count - 1), scene),
                       fate);
}

/// Reports that a run is resumed from its checkpoint, and removes later frames from its recording; or reports
/// that nothing is left to do, and changes nothing. Returns whether the run is resumed.
bool goes_on(const std::filesystem::path& file, const Runner& runner, const EndAt& end,
             RunRecorder& recorder) {
    const Scene& scene = runner.scene();
    const double now = runner.simulation().time();
    const Recording recording(file);
    if (runner.is_complete() && recording.end() == "complete") {
        report_nothing_left(file, now, scene);
        return false;
    }
    if (end.has_come(now)) {
        print_message(
            "sherd: the last checkpoint of '{}' is at {}, not before --until: nothing is left to do{}\n",
            file.string(), moment_words(now, scene),
            later_frame_words(recording, now, scene, "will be made again when the run is resumed"));
        return false;
    }
    print_message("sherd: '{}' is resumed at {}, its last checkpoint{}\n", file.string(),
                  moment_words(now, scene), later_frame_words(recording, now, scene, "are made again"));
    recorder.resume(scene);
    return true;
}

int run(const Scene& scene, const std::filesystem::path& file, const RunOptions& options) {
    require_no_input(file, scene);
    RunStart start = run_start(file, options);
    Runner runner = built_runner(scene_from(scene, start.checkpoint), threads_of_run(options.threads, 1));
    if (start.is_finished) {
        require_whole(file, runner.scene(), runner.end_time());
        report_nothing_left(file, runner.end_time(), scene);
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
                  moment_words(simulation.time(), scene));
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
    command->add_flag(
        "--resume", options->resume,
        fmt::format("Continue from the last checkpoint; only {} may differ", fmt::join(free_keys, " and ")));
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
