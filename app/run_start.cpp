// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run_start.h"

#include <fmt/format.h>

#include <cstdio>

#include "meshops/error.h"

namespace sherd {
namespace {

std::optional<Checkpoint> read_last(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    std::optional<Checkpoint> last = last_checkpoint(file, warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "sherd: warning: {}\n", warning);
    if (last && !std::filesystem::exists(file))
        throw Error(
            fmt::format("there are checkpoints of '{}', but not the recording itself: put it back, or "
                        "pass --force instead of --resume to begin anew",
                        file.string()));
    return last;
}

}  // namespace

RunStart run_start(const std::filesystem::path& file, const RunOptions& options) {
    RunStart start{RecordingOutput(file, options.force || options.resume), {}};
    if (options.resume) start.checkpoint = read_last(file);
    if (start.checkpoint) return start;
    const bool is_there = std::filesystem::exists(file);
    if (options.resume && is_there && !options.force && Recording(file).frame_count() > 0)
        throw Error(
            fmt::format("'{}' has no checkpoint to go on from; pass --force to begin anew", file.string()));
    if (options.resume)
        fmt::print(stderr, "sherd: '{}' has not been begun: the run starts at its beginning\n",
                   file.string());
    remove_checkpoints(file);
    return start;
}

}  // namespace sherd
