// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <vector>

#include "app/commands/commands.h"
#include "app/scene/scene.h"

namespace sherd {

/// The command line of `sherd run`.
struct RunOptions {
    SceneOptions scene;
    std::filesystem::path output;  ///< empty: recording_name(), in the working directory
    bool force = false;            ///< whether existing recordings are replaced
    bool resume = false;           ///< whether runs continue from their last checkpoints
    double until = std::numeric_limits<double>::infinity();  ///< s, simulated time at which runs end early
    int threads = 0;       ///< largest number of threads of a run; 0: by threads_of_run()
    int jobs = 2;          ///< number of variants that run at a time
    int progress_to = -1;  ///< descriptor for progress, as RunProgress::to_line(); -1: progress is on stderr
};

/// Default name of a recording: SCENE.h5, or SCENE-VARIANT.h5.
std::filesystem::path recording_name(const Scene& scene);

/// Runs the variants of a scene, `jobs` at a time, each in a process of its own, so that a crash of one run
/// does not affect the other runs. No variant is run unless all recordings can be written and are not locked.
/// Returns the exit code: interruption_exit_code() after an interruption, which ends all runs, else 0. Throws
/// Error (run) if variants failed, after all have ended.
int run_variants(std::span<const Scene> variants, const RunOptions& options);

}  // namespace sherd
