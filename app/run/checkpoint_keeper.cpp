// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/checkpoint_keeper.h"

#include <fmt/format.h>

#include "app/run/state_archive.h"
#include "meshops/error.h"

namespace sherd {

void CheckpointKeeper::restore(const Checkpoint& checkpoint) {
    require_same_run(checkpoint);
    parts.at_start = checkpoint.at_start;
    StateReader reader(checkpoint.state);
    reader(parts);
    reader.finish();
    number = checkpoint.number;
    last = Clock::now();
}

void CheckpointKeeper::paused(bool at_end) {
    const double interval = parts.runner.scene().checkpoint_interval;
    const bool is_due =
        number == 0 ||
        (interval > 0 && std::chrono::duration<double>(Clock::now() - last).count() >= interval);
    const bool is_soon_repeated = parts.runner.is_complete() && number == 1;
    if ((at_end && !is_soon_repeated) || is_due) write();
}

void CheckpointKeeper::ended(const RunEnd& how) {
    if (!how.is_complete()) return;
    const std::filesystem::path& recording = parts.recorder.lock().output();
    if (number > 1)
        remove_checkpoint(recording, number + 1);  // has the same file as number - 1, the older of the two
    else
        remove_checkpoints(recording);
}

void CheckpointKeeper::write() {
    const Clock::time_point start = Clock::now();
    parts.at_start = number == 0;
    // Each append to the recording has been committed, so all frames that the state refers to are on the
    // disk.
    write_checkpoint(parts.recorder.lock(),
                     {++number,
                      parts.runner.simulation().time(),
                      parts.runner.scene().frame_interval,
                      origin,
                      parts.at_start,
                      {}},
                     [this](StateVisitor& visit) { visit(parts); });
    last = Clock::now();
    spent += std::chrono::duration<double>(last - start).count();
}

void CheckpointKeeper::require_same_run(const Checkpoint& checkpoint) const {
    const Scene& scene = parts.runner.scene();
    std::string why = differences(checkpoint.origin, origin);
    if (scene.frame_interval != checkpoint.frame_interval)
        why +=
            fmt::format("output.every was {} and is {}\n", checkpoint.frame_interval, scene.frame_interval);
    if (!why.empty())
        throw Error(
            fmt::format("the run cannot be resumed, since its results would differ:\n"
                        "{}only {} may differ; --force instead of --resume starts again",
                        why, fmt::join(free_keys, " and ")));
    if (parts.runner.end_time() < checkpoint.time)
        throw Error(
            fmt::format("the last checkpoint of the run is at {:g} s, past duration = {:g}; give a longer "
                        "duration",
                        checkpoint.time, scene.duration));
}

}  // namespace sherd
