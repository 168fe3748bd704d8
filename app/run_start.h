// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/recording/recording.h"
#include "app/run/checkpoint.h"
#include "app/run_variants.h"

namespace sherd {

/// Where a run begins.
struct RunStart {
    RecordingOutput output;
    std::optional<Checkpoint> checkpoint;  ///< none: at the beginning
    bool is_finished = false;              ///< the recording is complete, and has no checkpoint
};

/// Decides where a run into `file` begins, and says so on stderr when that is not what --resume asks for:
/// where no recording is there yet, or one without a frame, the run begins anew. Throws Error (input) when
/// there is a recording but no checkpoint of it, or the other way round.
RunStart run_start(const std::filesystem::path& file, const RunOptions& options);

/// Throws Error (input) unless the complete recording in `file` is of the whole of the run, which ends at
/// `end_time`.
void require_whole(const std::filesystem::path& file, const Scene& scene, double end_time);

}  // namespace sherd
