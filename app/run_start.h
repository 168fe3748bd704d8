// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/recording/recording.h"
#include "app/run/checkpoint.h"
#include "app/run_variants.h"

namespace sherd {

/// The start of a run.
struct RunStart {
    RecordingOutput output;
    std::optional<Checkpoint> checkpoint;  ///< none: the run starts at its beginning
    bool is_finished = false;              ///< whether the recording is complete, and has no checkpoint
};

/// Finds the start of a run that is recorded in `file`. With --resume but no recording, or one without a
/// frame, the run starts at its beginning, and a message says so. Throws Error (input) if, with --resume,
/// there is an incomplete recording without a checkpoint, or a checkpoint without its recording.
RunStart run_start(const std::filesystem::path& file, const RunOptions& options);

/// Throws Error (input) unless the complete recording in `file` is of this scene and covers the whole run,
/// which ends at `end_time`.
void require_whole(const std::filesystem::path& file, const Scene& scene, double end_time);

}  // namespace sherd
