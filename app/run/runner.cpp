// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace sherd {
namespace {

constexpr double rounding = 1e-6;  // tolerance of times, as a share of a step

}  // namespace

Runner::Runner(Scene scene, BuiltScene built)
    : definition(std::move(scene)), stepped(std::move(built.sheets), built.options) {}

StepReport Runner::step() {
    StepReport report = stepped.step();
    const CrackEvents events = stepped.take_events();
    for (RunObserver& observer : observers) observer.stepped(report, events);
    return report;
}

StepReport Runner::advance() {
    const std::int64_t before = done();
    StepReport report = step();
    if (done() == before && !is_over()) return report;
    pause();
    if (has_frame(definition, done()) || is_over()) record();
    return report;
}

RunEnd Runner::run() {
    started = Clock::now();
    try {
        step_to_the_end();
    } catch (const std::exception& error) {
        end({std::string("failed: ") + error.what(), wall_seconds()});
        throw;
    }
    RunEnd how{is_complete() ? "complete" : "interrupted", wall_seconds()};
    end(how);
    return how;
}

void Runner::step_to_the_end() {
    pause();
    if (!resumed || has_frame_now()) record();
    while (!has_ended()) advance();
}

std::int64_t Runner::done() const {
    return static_cast<std::int64_t>(
        std::floor(stepped.time() / definition.simulation.stepper.step + rounding));
}

bool Runner::has_ended() const {
    return done() >= step_count(definition) || is_over();
}

bool Runner::is_complete() const {
    return stepped.time() == end_time() || stepped.arrived();
}

double Runner::end_time() const {
    return static_cast<double>(step_count(definition)) * definition.simulation.stepper.step;
}

double Runner::wall_seconds() const {
    if (!started) return seconds_before;
    return seconds_before + std::chrono::duration<double>(Clock::now() - *started).count();
}

bool Runner::has_frame_now() const {
    const bool between = stepped.time() != static_cast<double>(done()) * definition.simulation.stepper.step;
    return stepped.arrived() || (!between && has_frame(definition, done()));
}

void Runner::visit_state(StateVisitor& visit) {
    auto& [definition, stepped, observers, resumed, seconds_before, started] = *this;
    double seconds = wall_seconds();
    visit(stepped, seconds);
    if (!visit.reads()) return;
    seconds_before = seconds;
    resumed = true;
}

void Runner::pause() {
    const bool at_end = has_ended();
    for (RunObserver& observer : observers) observer.paused(at_end);
}

bool Runner::is_over() const {
    return stepped.arrived() ||
           std::ranges::any_of(observers, [](const RunObserver& observer) { return observer.should_end(); });
}

void Runner::record() {
    for (RunObserver& observer : observers) observer.frame_due(stepped);
}

void Runner::end(const RunEnd& how) {
    for (RunObserver& observer : observers) observer.ended(how);
}

}  // namespace sherd
