// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/race.h"

#include <algorithm>
#include <limits>

#include "app/machine/memory.h"
#include "app/machine/processor_time.h"
#include "app/scene/assemble/built_scene.h"

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

constexpr double no_limit = std::numeric_limits<double>::infinity();

class Runner {
  public:
    Runner(const Scene& scene, const std::optional<ShellMotion>& start) : run(scene, start) {
        result.vertices = run.shell().mass.size();
        result.faces = run.shell().triangles.size();
    }

    /// Continues to the time `end` (s), if the simulation is still in the race. If it takes more than
    /// `most_seconds` of processor time, counted from its beginning, it leaves the race.
    StepCost resume(double end, double most_seconds) {
        if (!is_racing()) return {};
        const StepCost cost = run.advance_to(end, most_seconds - seconds);
        seconds += cost.seconds;
        result.halvings += cost.halvings;
        result.failure = run.failure();
        result.is_out = result.failure.empty() && !run.has_reached(end);
        return cost;
    }
    bool is_racing() const { return result.has_finished(); }
    double seconds_so_far() const { return seconds; }
    void keep_motion() { result.end = run.motion(); }

    RaceResult result;

  private:
    MeasuredRun run;
    double seconds = 0;
};

/// Makes a runner for each scene, which makes its settling laps before the next runner is made, so that
/// RaceResult::memory is that of this runner alone.
std::vector<Runner> settled(const std::vector<Scene>& scenes, const RaceOptions& options,
                            const std::optional<ShellMotion>& start) {
    std::vector<Runner> runners;
    runners.reserve(scenes.size());
    for (const Scene& scene : scenes) {
        reset_peak_memory();
        const double before = resident_memory();
        Runner& runner = runners.emplace_back(scene, start);
        const bool first = runners.size() == 1;
        runner.resume(options.settling * options.step,
                      first ? no_limit : options.allowance * runners[0].seconds_so_far());
        runner.result.memory = std::max(0.0, peak_memory() - before);
    }
    return runners;
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

StepCost RaceResult::cost() const {
    StepCost sum;
    for (const StepCost& lap : laps) sum += lap;
    return sum;
}

std::vector<RaceResult> race(const std::vector<Scene>& scenes, const RaceOptions& options,
                             const std::optional<ShellMotion>& start) {
    std::vector<Runner> runners = settled(scenes, options, start);
    for (int lap = 1; lap <= options.laps; ++lap)
        for (Runner& runner : runners) {
            if (!runner.is_racing()) continue;
            const bool first = &runner == &runners[0];
            runner.result.laps.push_back(
                runner.resume((options.settling + lap) * options.step,
                              first ? no_limit : options.allowance * runners[0].seconds_so_far()));
        }
    std::vector<RaceResult> results;
    for (Runner& runner : runners) {
        runner.keep_motion();
        results.push_back(std::move(runner.result));
    }
    return results;
}

}  // namespace sherd
