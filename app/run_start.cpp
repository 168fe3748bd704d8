// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_start.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

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

}  // namespace

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

}  // namespace sherd
