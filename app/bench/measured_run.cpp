// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/measured_run.h"

#include "app/machine/processor_time.h"
#include "app/scene/build/built_scene.h"

namespace sherd {
namespace {

std::unique_ptr<Simulation> make_simulation(const Scene& scene, const std::optional<ShellMotion>& start) {
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    if (start) {
        built.sheets.mechanics().position = start->position;
        built.sheets.mechanics().velocity = start->velocity;
    }
    return std::make_unique<Simulation>(std::move(built.sheets), built.options);
}

}  // namespace

StepCost& StepCost::operator+=(const StepCost& more) {
    seconds += more.seconds;
    simulated += more.simulated;
    steps += more.steps;
    iterations += more.iterations;
    factorizations += more.factorizations;
    analyses += more.analyses;
    stages += more.stages;
    halvings += more.halvings;
    contacts += more.contacts;
    return *this;
}

MeasuredRun::MeasuredRun(const Scene& scene, const std::optional<ShellMotion>& start)
    : simulation(make_simulation(scene, start)) {}

StepCost MeasuredRun::advance_to(double end, double most_seconds) {
    StepCost cost;
    if (!why.empty()) return cost;
    const TimeSpent before = simulation->time_spent();
    const double start = processor_seconds(), begin = time();
    try {
        while (!has_reached(end) && processor_seconds() - start <= most_seconds) {
            const StepReport report = simulation->step();
            ++cost.steps;
            cost.iterations += report.newton_iterations;
            cost.stages += report.stages;
            cost.halvings += report.halvings;
            cost.contacts += report.contacts;
        }
    } catch (const std::exception& error) {
        why = error.what();
    }
    cost.seconds = processor_seconds() - start;
    cost.simulated = time() - begin;
    const TimeSpent& after = simulation->time_spent();
    cost.factorizations = after.times(Task::factorization) - before.times(Task::factorization);
    cost.analyses = after.times(Task::analysis) - before.times(Task::analysis);
    return cost;
}

}  // namespace sherd
