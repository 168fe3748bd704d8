// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/run_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include "app/machine/memory.h"
#include "app/messages/counted.h"
#include "app/recording/recording_size.h"
#include "app/run/runner.h"
#include "app/scene/assemble/sheet/supports.h"

namespace sherd {
namespace {

constexpr int most_steps = 3;
constexpr double patience = 3;  // s, after which no further step is tried
constexpr double day = 86400;   // s

/// Memory, bytes, of a simulation of unfractured sheets with this many faces. Most of it is for factors of
/// Newton's matrix. The formula is fitted to plates of 2,739 and 10,359 faces, without contact.
double guessed_memory(double faces) {
    return 40e6 + 900 * faces * std::log2(std::max(2.0, faces));
}

std::string bytes_words(double bytes) {
    if (bytes < 1e9) return fmt::format("{:.0f} MB", std::max(1.0, bytes / 1e6));
    return fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string time_words(double seconds) {
    if (seconds < 90) return fmt::format("{:.2g} s", seconds);
    if (seconds < 90 * 60) return fmt::format("{:.2g} min", seconds / 60);
    if (seconds < 2 * day) return fmt::format("{:.2g} h", seconds / 3600);
    return fmt::format("{:.3g} days", seconds / day);
}

MeshSize mesh_size(const BuiltScene& built) {
    MeshSize size;
    for (const SheetInput& input : built.inputs) {
        size.vertices += static_cast<double>(input.mesh.number_of_vertices());
        size.faces += static_cast<double>(input.mesh.number_of_faces());
        size.edges += static_cast<double>(input.mesh.number_of_edges());
    }
    const ContactOptions& contact = built.options.stepper.contact;
    for (const Obstacle& obstacle : contact.obstacles)
        if (obstacle.surface && obstacle.moves()) size.moving_points += obstacle.surface->size();
    for (const RigidBody& body : contact.bodies) size.moving_points += body.surface->size();
    return size;
}

}  // namespace

RunCost run_cost(const Scene& scene, const BuiltScene& built) {
    RunCost cost;
    cost.steps = step_count(scene);
    cost.frames = frame_count(scene);
    const MeshSize mesh = mesh_size(built);
    double columns = static_cast<double>(6 * support_names(scene).size());
    for (const GaugeSpec& gauge : scene.gauges)
        columns += 3 * (gauge.displacement + 2 * gauge.fields.stress + gauge.fields.curvature +
                        gauge.fields.membrane_strain);
    cost.recording = recording_size(mesh, static_cast<double>(cost.frames), static_cast<double>(cost.steps),
                                    columns, scene.simulation.fields);
    cost.memory = guessed_memory(mesh.faces);
    cost.machine_memory = machine_memory();
    return cost;
}

TriedSteps try_steps(const Scene& scene, BuiltScene built) {
    using Clock = std::chrono::steady_clock;
    TriedSteps tried;
    try {
        const auto start = Clock::now();
        const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
        Runner runner(scene, std::move(built));
        tried.later = std::numeric_limits<double>::infinity();
        while (tried.count < most_steps && (tried.count == 0 || seconds() < patience)) {
            const double begin = seconds();
            const StepReport report = runner.step();
            raise_peaks(tried.peaks, report);
            // A halved step is only part of a step of the scene.
            const double whole = (seconds() - begin) * scene.simulation.stepper.step / report.step_size;
            if (tried.count++ == 0) tried.first = whole;
            // The cheapest step counts: the first step also sets up the solver, and steps in which something
            // fails take longer, but are few in most runs.
            tried.later = std::min(tried.later, whole);
        }
    } catch (const std::exception& error) {
        tried.failure = error.what();
    }
    return tried;
}

void add(RunCost& cost, const TriedSteps& tried) {
    if (!tried.failure.empty()) return;
    cost.seconds = tried.first + tried.later * static_cast<double>(cost.steps - 1);
    cost.peak_memory = peak_memory();
}

std::string cost_lines(const RunCost& cost) {
    std::string text =
        fmt::format("will take {}, {}, a recording of about {}, memory of about {}\n",
                    counted(cost.steps, "step"), counted(cost.frames, "frame"), bytes_words(cost.recording),
                    bytes_words(cost.peak_memory > 0 ? cost.peak_memory : cost.memory));
    if (cost.seconds > 0)
        text += fmt::format(
            "will take about {} on this machine, estimated from the first steps; contact makes later steps "
            "several times as long, and cracks often 10 to 100 times\n",
            time_words(cost.seconds));
    return text;
}

void warn_of_cost(const Scene& scene, const RunCost& cost, std::vector<std::string>& warnings) {
    const std::string file = scene.file.string();
    if (cost.seconds > day)
        warnings.push_back(
            fmt::format("{}: will take more than a day, about {}: try a coarser mesh, a longer "
                        "solver.step or a shorter duration first",
                        file, time_words(cost.seconds)));
    if (const double memory = std::max(cost.memory, cost.peak_memory); memory > cost.machine_memory)
        warnings.push_back(
            fmt::format("{}: will take about {} of memory, more than the {} of this machine: make "
                        "the mesh coarser",
                        file, bytes_words(memory), bytes_words(cost.machine_memory)));
}

}  // namespace sherd
