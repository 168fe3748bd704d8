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

/// A moment of a run from which it can go on.
struct Checkpoint {
    std::int64_t number = 0;    ///< of the run's checkpoints, from 1
    double time = 0;            ///< s, simulated
    double frame_interval = 0;  ///< s, of the run
    RunOrigin origin;
    bool at_start = false;  ///< no step has been made: all that is simulated follows from the scene
    std::string state;      ///< of all that takes part: StateWriter; empty while it is written

    /// The state itself, most of it, stands behind this as it is.
    void visit_state(StateVisitor& visit) {
        auto& [number, time, frame_interval, origin, at_start, state] = *this;
        visit(number, time, frame_interval, origin, at_start);
    }
};

/// The two files beside a recording that have the last checkpoints in turn: RECORDING.checkpoint-1 and -2.
std::array<std::filesystem::path, 2> checkpoint_files(const std::filesystem::path& recording);

/// Replaces the older one of the two. A reader finds a file as it was before or all of the new one, even
/// after a power cut. visit_all: visits what becomes Checkpoint::state, which is never in memory as a whole.
/// Throws Error (run).
void write_checkpoint(const OutputLock& recording, Checkpoint checkpoint,
                      const std::function<void(StateVisitor&)>& visit_all);

/// Returns the last one that is whole, if there is any, and adds a warning for each file that is not. What a
/// killed writer left is removed: nobody else must write the recording.
std::optional<Checkpoint> last_checkpoint(const std::filesystem::path& recording,
                                          std::vector<std::string>& warnings);

/// Removes the one of this number, if it is there.
void remove_checkpoint(const std::filesystem::path& recording, std::int64_t number);

/// Removes both, and what a killed writer left.
void remove_checkpoints(const std::filesystem::path& recording);

}  // namespace sherd
