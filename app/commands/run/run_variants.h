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
    bool force = false;            ///< replace recordings that exist
    bool resume = false;           ///< resume from the last checkpoints
    double until = std::numeric_limits<double>::infinity();  ///< s, simulated time of an early end
    int threads = 0;                                         ///< most threads of a run; 0: threads_of_run()
    int jobs = 2;                                            ///< variants at a time
    int progress_to = -1;  ///< descriptor for RunProgress::to_line(), instead of stderr; -1: none
};

/// Default name of a recording: SCENE.h5, or SCENE-VARIANT.h5.
std::filesystem::path recording_name(const Scene& scene);

/// Runs the variants of a scene, `jobs` at a time, each in a process of its own, so that a crash of one does
/// not affect the others. None is run unless all recordings can be written and are not locked. Returns the
/// exit code: interruption_exit_code() after an interruption, which ends all of them. Throws Error (run) if
/// some variants failed, after all have ended.
int run_variants(std::span<const Scene> variants, const RunOptions& options);

}  // namespace sherd
