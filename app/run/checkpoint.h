// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/files/output_lock.h"
#include "app/run/run_origin.h"

namespace sherd {

/// Stored state of a run, from which it can be resumed.
struct Checkpoint {
    std::int64_t number = 0;    ///< number among the run's checkpoints, from 1
    double time = 0;            ///< s, simulated
    double frame_interval = 0;  ///< s, frame interval of the run
    RunOrigin origin;
    bool at_start = false;  ///< no step has been made: the simulation follows from the scene
    std::string state;      ///< state of the RunParts, by StateWriter; empty while it is written

    /// Visits all but `state`, which follows in the file without a length.
    void visit_state(StateVisitor& visit) {
        auto& [number, time, frame_interval, origin, at_start, state] = *this;
        visit(number, time, frame_interval, origin, at_start);
    }
};

/// The two files beside a recording that hold its checkpoints in turn: RECORDING.checkpoint-1 and -2.
std::array<std::filesystem::path, 2> checkpoint_files(const std::filesystem::path& recording);

/// Replaces the older checkpoint. A reader finds the file as it was before or all of the new one, even after
/// a power cut. visit_all: visits the data of Checkpoint::state, which are never in memory as a whole. Throws
/// Error (run).
void write_checkpoint(const OutputLock& recording, Checkpoint checkpoint,
                      const std::function<void(StateVisitor&)>& visit_all);

/// Returns the last intact checkpoint, if there is one, and adds a warning for each damaged file. Removes the
/// files that a killed writer left; no other program may write the recording meanwhile.
std::optional<Checkpoint> last_checkpoint(const std::filesystem::path& recording,
                                          std::vector<std::string>& warnings);

/// Removes the checkpoint of this number, if it exists.
void remove_checkpoint(const std::filesystem::path& recording, std::int64_t number);

/// Removes both checkpoints, and the files that a killed writer left.
void remove_checkpoints(const std::filesystem::path& recording);

}  // namespace sherd
