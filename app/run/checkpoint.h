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

/// Origin of a run: runs of the same origin give the same bits.
struct RunOrigin {
    std::string program;                          ///< version, and checksum of the program's file
    std::map<std::string, std::string> settings;  ///< Scene::settings, but those that may change
    std::map<std::string, std::uint64_t> meshes;  ///< checksums of the input files
    std::uint64_t start = 0;                      ///< checksum of the initial state

    void visit_state(StateVisitor& visit) {
        auto& [program, settings, meshes, start] = *this;
        visit(program, settings, meshes, start);
    }
};

/// Returns the origin of a run before its first step.
RunOrigin run_origin(const Runner& runner);

/// Returns the differences of `now` from `before`, a line each, or "".
std::string differences(const RunOrigin& before, const RunOrigin& now);

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
