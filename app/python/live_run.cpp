// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/live_run.h"

#include <pybind11/pybind11.h>

#include <utility>

#include "app/python/without_lock.h"
#include "app/run/checkpoint.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/squeeze.h"
#include "meshops/error.h"

namespace sherd::python {
namespace {

BuiltScene built(const Scene& scene, int threads, std::vector<std::string>& warnings) {
    BuiltScene built = build_scene(scene, warnings);
    warn_of_squeezes(scene, built, warnings);
    built.options.stepper.threads = threads;
    built.options.stepper.shell.given_forces = true;
    return built;
}

}  // namespace

ExclusiveUse::ExclusiveUse(std::atomic<bool>& taken) : taken(taken) {
    if (taken.exchange(true))
        throw Error(
            "the simulation is making a step in another thread: wait for it, or give each thread a "
            "simulation of its own",
            Fault::run);
}

LiveRun::LiveRun(const Scene& scene, int threads) : runner(scene, built(scene, threads, warning_list)) {
    runner.add(*this);
}

void LiveRun::step() {
    const ExclusiveUse turn(taken);  // before another thread gets Python's lock
    const WithoutLock others;
    runner.advance();
}

bool LiveRun::has_ended() {
    const ExclusiveUse turn(taken);
    return runner.has_ended();
}

const Simulation& LiveRun::simulation() {
    const ExclusiveUse turn(taken);
    return runner.simulation();
}

Simulation& LiveRun::changed() {
    const ExclusiveUse turn(taken);
    return runner.simulation();
}

const std::optional<StepReport>& LiveRun::report() {
    const ExclusiveUse turn(taken);
    return last;
}

const CrackEvents& LiveRun::events() {
    const ExclusiveUse turn(taken);
    return all_events;
}

void LiveRun::record(const std::filesystem::path& file, bool force) {
    const ExclusiveUse turn(taken);
    if (recording) throw Error("the simulation is being recorded: end that recording first");
    if (last) throw Error("the simulation has made a step: a recording must begin before the first step");
    RecordingOutput output(file, force, "force=True");
    remove_checkpoints(file);
    recording.reset(new LiveRecording{
        RunRecorder(std::move(output), runner.scene(), std::as_const(runner).simulation())});
    frame_due(runner.simulation());
}

void LiveRun::end_recording(const std::string& failure) {
    const ExclusiveUse turn(taken);
    if (!recording) return;
    const std::unique_ptr<LiveRecording> ending = std::move(recording);
    const Simulation& simulation = runner.simulation();
    if (failure.empty() && ending->last_frame != simulation.time()) ending->recorder.frame_due(simulation);
    const double seconds = std::chrono::duration<double>(Clock::now() - ending->begin).count();
    if (!failure.empty())
        ending->recorder.ended({"failed: " + failure, seconds});
    else
        ending->recorder.ended({runner.is_complete() ? "complete" : "interrupted", seconds});
}

void LiveRun::stepped(const StepReport& report, const CrackEvents& events) {
    last = report;
    append(all_events, events);
    if (recording) recording->recorder.stepped(report, events);
}

void LiveRun::frame_due(const Simulation& simulation) {
    if (!recording) return;
    const pybind11::gil_scoped_acquire python;
    recording->recorder.frame_due(simulation);
    recording->last_frame = simulation.time();
}

}  // namespace sherd::python
