// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <span>
#include <vector>

#include "app/commands.h"
#include "app/scene/scene.h"

namespace sherd {

/// The command line of `sherd run`.
struct RunOptions {
    SceneOptions scene;
    std::filesystem::path output;  ///< empty: named after the scene, in the working directory
    bool force = false;            ///< replace recordings that exist
    bool resume = false;           ///< go on from their last checkpoints
    double until = std::numeric_limits<double>::infinity();  ///< s, simulated; when the run ends early
    int threads = 0;                                         ///< of a run, at most; 0: see threads_of_run()
    int jobs = 2;                                            ///< variants at a time
    int progress_to = -1;  ///< descriptor for to_line() of RunProgress, instead of stderr; -1: none
};

/// SCENE.h5, or SCENE-VARIANT.h5.
std::filesystem::path recording_name(const Scene& scene);

/// Runs the variants of a scene, `jobs` at a time, each in a process of its own: what happens in one stays
/// there. Nothing is run unless all recordings can be written and nobody writes them. Returns the exit code:
/// interruption_exit_code() after an interruption, which ends all of them. Throws Error (run) when some
/// variants failed, after all have ended.
int run_variants(std::span<const Scene> variants, const RunOptions& options);

}  // namespace sherd
