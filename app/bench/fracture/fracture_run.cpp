// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/fracture/fracture_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/bench/fracture/grown_crack.h"
#include "app/machine/processor_time.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"
#include "meshops/error.h"

namespace sherd {
namespace {

Scene scene_of(const FractureCase& one, double edge, int seed) {
    const std::filesystem::path folder = shipped_scene_folder();
    return read_scene(
        shipped_scene(one.scene, shipped_scenes(folder)).file,
        {{fmt::format("seed={}", seed), fmt::format("sheet.plate.mesh.edge_length={}", edge)}, one.variant});
}

void run_to_the_end(const Scene& scene, Simulation& simulation, FractureHistory& history) {
    while (simulation.time() < scene.duration && !simulation.arrived()) {
        history.steps.push_back(simulation.step());
        append(history.events, simulation.take_events());
    }
}

std::vector<Vector2d> path_of_crack(const FractureHistory& history) {
    std::vector<Vector2d> path;
    for (const GrownEdge& grown : grown_edges(history)) {
        if (path.empty()) path.push_back(grown.from);
        path.push_back(grown.to);
    }
    return path;
}

double distance(const Vector2d& point, const std::vector<Vector2d>& path) {
    double least = (point - path.front()).norm();
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vector2d way = path[i] - path[i - 1];
        const double share = std::clamp((point - path[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
        least = std::min(least, (point - path[i - 1] - share * way).norm());
    }
    return least;
}

}  // namespace

FractureRun run_fracture(const FractureCase& one, double edge, int seed) {
    const double start = processor_seconds();
    const Scene scene = scene_of(one, edge, seed);
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    if (one.replace_loads) one.replace_loads(scene, built.sheets.mechanics(), built.options);
    Simulation simulation(std::move(built.sheets), built.options);
    FractureRun run;
    run.faces = simulation.shell().mechanics().triangles.size();
    FractureHistory history{scene, {}, {}, {}};
    try {
        run_to_the_end(scene, simulation, history);
    } catch (const Error& error) {
        run.failure = error.what();
    }
    history.rest = simulation.shell().mechanics().rest;
    if (one.has_crack) run.path = path_of_crack(history);
    if (!one.has_crack || !run.path.empty())
        run.values = one.measure(history);
    else if (run.failure.empty())
        run.failure = "no crack grew";
    run.seconds = processor_seconds() - start;
    return run;
}

double largest_distance(const std::vector<std::vector<Vector2d>>& paths) {
    double largest = 0;
    for (const auto& one : paths)
        for (const auto& other : paths)
            for (const Vector2d& point : one) largest = std::max(largest, distance(point, other));
    return largest;
}

}  // namespace sherd
