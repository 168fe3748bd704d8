// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene.h"

#include <cmath>

namespace sherd {
namespace {

/// Number of intervals of output.every that have ended at the end of a step.
std::int64_t intervals(const Scene& scene, std::int64_t step) {
    return static_cast<std::int64_t>(
        std::floor(static_cast<double>(step) * scene.simulation.stepper.step / scene.frame_interval + 1e-6));
}

}  // namespace

std::vector<std::filesystem::path> input_files(const Scene& scene) {
    std::vector<std::filesystem::path> files;
    for (const SheetSpec& sheet : scene.sheets)
        if (const auto* mesh = std::get_if<MeshFile>(&sheet.mesh)) files.push_back(mesh->path);
    for (const ObstacleSpec& obstacle : scene.obstacles) {
        if (const auto* mesh = std::get_if<ObstacleMesh>(&obstacle.shape)) files.push_back(mesh->file.path);
        if (const ObstacleCache* cache = cache_of(obstacle)) files.push_back(cache->path);
    }
    return files;
}

std::int64_t step_count(const Scene& scene) {
    return static_cast<std::int64_t>(std::ceil(scene.duration / scene.simulation.stepper.step - 1e-6));
}

bool has_frame(const Scene& scene, std::int64_t step) {
    return intervals(scene, step) > intervals(scene, step - 1) || step == step_count(scene);
}

std::int64_t frame_count(const Scene& scene) {
    const std::int64_t steps = step_count(scene);
    // An interval is at least a step long, so that no two of them end in the same step: each has a frame.
    return intervals(scene, steps - 1) + 2;
}

}  // namespace sherd
