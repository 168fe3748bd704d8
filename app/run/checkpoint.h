// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/files/disk/output_lock.h"
#include "app/run/runner.h"

namespace sherd {

/// Data that determine the results of a run: runs of equal origin give the same results, bit for bit.
struct RunOrigin {
    std::string program;                          ///< version, and checksum of the program's file
    std::map<std::string, std::string> settings;  ///< Scene::settings that a resumed run may not change
    std::map<std::string, std::uint64_t> meshes;  ///< checksums of input_files(), by paths relative to the
                                                  ///< scene's folder
    std::uint64_t start = 0;                      ///< checksum of the initial state of sheets and obstacles

    void visit_state(StateVisitor& visit) {
        auto& [program, settings, meshes, start] = *this;
        visit(program, settings, meshes, start);
    }
};

/// Returns the origin of a run that has not made a step yet.
RunOrigin run_origin(const Runner& runner);

/// Returns a message with a line for each difference between `before` and `now`; "" if they are equal.
std::string differences(const RunOrigin& before, const RunOrigin& now);

/// Stored state of a run, from which it can be resumed.
struct Checkpoint {
    std::int64_t number = 0;    ///< number among the run's checkpoints, from 1
    double time = 0;            ///< s, simulated time of the state; in statics, see StepReport::load
    double frame_interval = 0;  ///< s, frame interval of the run
    RunOrigin origin;
    bool at_start = false;  ///< whether no step has been made, so that `state` lacks the simulation
    std::string state;      ///< state of RunParts, as StateWriter writes it; empty in a checkpoint to be
                            ///< written

    /// Visits all members but `state`, whose bytes follow in the file without their number.
    void visit_state(StateVisitor& visit) {
        auto& [number, time, frame_interval, origin, at_start, state] = *this;
        visit(number, time, frame_interval, origin, at_start);
    }
};

/// Settings that a resumed run may change: its duration, and the time between checkpoints.
inline constexpr std::array<const char*, 2> free_keys = {"duration", "output.checkpoint"};

/// Returns the two files beside a recording, RECORDING.checkpoint-1 and RECORDING.checkpoint-2, to which its
/// checkpoints are written in turn.
std::array<std::filesystem::path, 2> checkpoint_files(const std::filesystem::path& recording);

/// Writes a checkpoint in place of the older one of the recording's two. A reader finds the old file or the
/// complete new one, even after a power cut. recording: lock of the recording; visit_all: visits the data of
/// Checkpoint::state, which is written directly and is never in memory as a whole. Throws Error (run) if the
/// file cannot be written.
void write_checkpoint(const OutputLock& recording, Checkpoint checkpoint,
                      const std::function<void(StateVisitor&)>& visit_all);

/// Returns the last intact checkpoint, if there is one, and adds a warning for each damaged file. Removes
/// unfinished files that a killed writer left; no other program may write the recording meanwhile.
std::optional<Checkpoint> last_checkpoint(const std::filesystem::path& recording,
                                          std::vector<std::string>& warnings);

/// Removes the checkpoint with this number, if it exists.
void remove_checkpoint(const std::filesystem::path& recording, std::int64_t number);

/// Removes both checkpoints of a recording, and unfinished files and lock files that a killed writer left.
void remove_checkpoints(const std::filesystem::path& recording);

}  // namespace sherd
