// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run/run_variants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <list>

#include "app/files/disk/pending_file.h"
#include "app/machine/threads.h"
#include "app/messages/print.h"
#include "app/messages/shell_quoting.h"
#include "app/process/child_run.h"
#include "app/progress/interruption.h"
#include "app/progress/progress_display.h"
#include "app/recording/recording.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr int poll_interval = 50;  // ms, longest delay until an interruption is noticed

/// The path from which part_file() makes the recordings' names: the recording of the scene without variants.
fs::path common_output(const Scene& first, const RunOptions& options) {
    if (options.output.extension() == ".h5") return options.output;
    return options.output / fmt::format("{}.h5", first.file.stem().string());
}

std::vector<fs::path> recordings(std::span<const Scene> variants, const fs::path& common) {
    std::vector<fs::path> files;
    for (const Scene& scene : variants) files.push_back(part_file(common, scene.variant));
    return files;
}

/// The command line that runs one variant.
std::vector<std::string> arguments_of(const std::string& variant, const fs::path& recording,
                                      const RunOptions& options) {
    std::vector<std::string> arguments{"run",           path_argument(options.scene.file),
                                       "--variant",     variant,
                                       "--output",      recording.string(),
                                       "--progress-to", std::to_string(ChildProcess::report_descriptor)};
    for (const std::string& assignment : options.scene.choice.overrides)
        arguments.insert(arguments.end(), {"--set", assignment});
    if (options.force) arguments.push_back("--force");
    if (options.resume) arguments.push_back("--resume");
    if (std::isfinite(options.until))
        arguments.insert(arguments.end(), {"--until", fmt::format("{}", options.until)});
    arguments.insert(arguments.end(),
                     {"--threads", fmt::format("{}", threads_of_run(options.threads, options.jobs))});
    return arguments;
}

/// Runs variants in parallel, each in a process of its own, and shows their progress.
class VariantRunner {
  public:
    VariantRunner(std::span<const Scene> variants, std::span<const fs::path> files, const RunOptions& options)
        : variants(variants), files(files), options(options), display(longest_name(variants)) {}

    /// Returns the names of the failed variants, after all have ended.
    std::vector<std::string> run();
    /// Whether an interruption has ended the runs.
    bool stopped = false;
    /// Number of variants that have not been run to their end.
    std::size_t left() const { return variants.size() - complete; }

  private:
    static std::size_t longest_name(std::span<const Scene> variants);
    void start_some();
    void wait_for_output() const;
    void listen();
    void finish(ChildRun& run);
    void show();
    void stop();

    std::span<const Scene> variants;
    std::span<const fs::path> files;
    const RunOptions& options;
    ProgressDisplay display;
    std::list<ChildRun> running;
    std::size_t next = 0;  ///< next variant to start
    std::size_t complete = 0;
    std::vector<std::string> failed;
};

std::size_t VariantRunner::longest_name(std::span<const Scene> variants) {
    std::size_t longest = 0;
    for (const Scene& scene : variants) longest = std::max(longest, scene.variant.size());
    return longest;
}

void VariantRunner::start_some() {
    while (next < variants.size() && running.size() < static_cast<std::size_t>(options.jobs)) {
        const std::string& variant = variants[next].variant;
        running.emplace_back(variant, variants[next].duration, arguments_of(variant, files[next], options));
        ++next;
    }
}

void VariantRunner::wait_for_output() const {
    std::vector<pollfd> pipes;
    for (const ChildRun& run : running) run.add_pipes(pipes);
    poll(pipes.data(), pipes.size(), poll_interval);
}

void VariantRunner::listen() {
    for (auto run = running.begin(); run != running.end();) {
        const bool goes_on = run->listen();
        if (const std::string words = run->take_words(); !words.empty()) {
            display.clear_for_output();
            print_message("{}", words);
        }
        if (goes_on) {
            ++run;
            continue;
        }
        show();  // the last progress of the variant
        finish(*run);
        run = running.erase(run);
    }
}

void VariantRunner::finish(ChildRun& run) {
    if (run.finish() == 0)
        ++complete;
    else
        failed.push_back(run.name);
    display.clear_for_output();
    display.leave(run.meter);
    if (!run.results.empty()) print_result("variant {}\n{}\n", run.name, run.results);
    std::fflush(stdout);
}

void VariantRunner::show() {
    std::vector<ProgressMeter*> meters;
    for (ChildRun& run : running) meters.push_back(&run.meter);
    display.show(meters);
}

void VariantRunner::stop() {
    stopped = true;
    next = variants.size();
    for (ChildRun& run : running) run.interrupt();
}

std::vector<std::string> VariantRunner::run() {
    while (next < variants.size() || !running.empty()) {
        start_some();
        wait_for_output();
        listen();
        show();
        if (interrupted() && !stopped) stop();
    }
    return failed;
}

}  // namespace

fs::path recording_name(const Scene& scene) {
    const std::string variant = scene.variant.empty() ? "" : "-" + scene.variant;
    return fmt::format("{}{}.h5", scene.file.stem().string(), variant);
}

int run_variants(std::span<const Scene> variants, const RunOptions& options) {
    const fs::path common = common_output(variants.front(), options);
    const std::vector<fs::path> files = recordings(variants, common);
    make_folder(common.parent_path());
    const OutputLock lock(common);  // each process locks its own recording once it is started
    for (const fs::path& file : files) RecordingOutput(file, options.force || options.resume);
    watch_for_interruption();
    VariantRunner runner(variants, files, options);
    const std::vector<std::string> failed = runner.run();
    if (runner.stopped) {
        print_message(
            "sherd: interrupted; of {} variants {} were not run to their end; --resume continues them\n",
            variants.size(), runner.left());
        return interruption_exit_code();
    }
    if (!failed.empty())
        throw Error(fmt::format("{} of {} variants failed: {}", failed.size(), variants.size(),
                                fmt::join(failed, ", ")),
                    Fault::run);
    return 0;
}

}  // namespace sherd
