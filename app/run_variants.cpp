// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_variants.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <list>

#include "app/child_process.h"
#include "app/interruption.h"
#include "app/recording/recording_file.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

constexpr int patience = 50;  // ms until an interruption is seen

/// A variant that is being run.
class VariantRun {
  public:
    VariantRun(std::string variant, std::vector<std::string> arguments)
        : variant(std::move(variant)), process(std::move(arguments)) {}

    /// Passes on what it has to say: its progress at once, line by line with its name in front, its results
    /// at its end. Returns false when there will be no more.
    bool listen();
    /// Waits for its end and prints its results; returns its exit code.
    int finish();
    void interrupt() { process.interrupt(); }

    std::string variant;

  private:
    void show_lines();

    ChildProcess process;
    std::string results, line;
    bool out_open = true, err_open = true;
};

/// Appends what there is in a pipe; false at its end.
bool read_some(int pipe, std::string& text) {
    std::array<char, 4096> buffer;
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

void VariantRun::show_lines() {
    for (std::size_t end = line.find('\n'); end != std::string::npos; end = line.find('\n')) {
        fmt::print(stderr, "{}: {}\n", variant, line.substr(0, end));
        line.erase(0, end + 1);
    }
}

bool VariantRun::listen() {
    std::array<pollfd, 2> pipes{pollfd{out_open ? process.out : -1, POLLIN, 0},
                                pollfd{err_open ? process.err : -1, POLLIN, 0}};
    if (poll(pipes.data(), pipes.size(), patience) <= 0) return true;
    if (pipes[0].revents != 0) out_open = read_some(process.out, results);
    if (pipes[1].revents != 0) err_open = read_some(process.err, line);
    show_lines();
    return out_open || err_open;
}

int VariantRun::finish() {
    const int exit_code = process.wait();
    if (!line.empty()) fmt::print(stderr, "{}: {}\n", variant, line);
    if (!results.empty()) fmt::print("variant {}\n{}\n", variant, results);
    std::fflush(stdout);
    return exit_code;
}

std::vector<fs::path> recordings(std::span<const Scene> variants, const RunOptions& options) {
    std::vector<fs::path> files;
    for (const Scene& scene : variants) {
        fs::path file = options.output / recording_name(scene);
        if (options.output.extension() == ".h5") file = part_file(options.output, scene.variant);
        files.push_back(file);
    }
    return files;
}

/// The command line that runs one variant.
std::vector<std::string> arguments_of(const std::string& variant, const fs::path& recording,
                                      const RunOptions& options) {
    std::vector<std::string> arguments{"run",      options.scene.file.string(), "--variant", variant,
                                       "--output", recording.string()};
    for (const std::string& assignment : options.scene.choice.overrides)
        arguments.insert(arguments.end(), {"--set", assignment});
    if (options.force) arguments.push_back("--force");
    return arguments;
}

}  // namespace

fs::path recording_name(const Scene& scene) {
    const std::string variant = scene.variant.empty() ? "" : "-" + scene.variant;
    return fmt::format("{}{}.h5", scene.file.stem().string(), variant);
}

int run_variants(std::span<const Scene> variants, const RunOptions& options) {
    const std::vector<fs::path> files = recordings(variants, options);
    for (const fs::path& file : files) check_free(file, options.force);
    make_folder(files.front().parent_path());
    watch_for_interruption();
    std::list<VariantRun> running;
    std::vector<std::string> failed;
    bool stopping = false;
    for (std::size_t next = 0; next < variants.size() || !running.empty();) {
        while (next < variants.size() && running.size() < static_cast<std::size_t>(options.jobs) &&
               !stopping) {
            running.emplace_back(variants[next].variant,
                                 arguments_of(variants[next].variant, files[next], options));
            ++next;
        }
        for (auto run = running.begin(); run != running.end();) {
            if (run->listen()) {
                ++run;
                continue;
            }
            if (run->finish() != 0) failed.push_back(run->variant);
            run = running.erase(run);
        }
        if (interrupted() && !stopping) {
            stopping = true;
            next = variants.size();
            for (VariantRun& run : running) run.interrupt();
        }
    }
    if (stopping) return 1;
    if (!failed.empty())
        throw Error(fmt::format("{} of {} variants failed: {}", failed.size(), variants.size(),
                                fmt::join(failed, ", ")),
                    Fault::run);
    return 0;
}

}  // namespace sherd
