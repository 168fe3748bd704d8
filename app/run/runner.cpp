// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/runner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace sherd {
namespace {

constexpr double rounding = 1e-6;  // of a step

}  // namespace

Runner::Runner(Scene scene, BuiltScene built)
    : definition(std::move(scene)), stepped(std::move(built.sheets), built.options) {}

StepReport Runner::step() {
    StepReport report = stepped.step();
    const CrackEvents events = stepped.take_events();
    for (RunObserver& observer : observers) observer.stepped(report, events);
    return report;
}

RunEnd Runner::run() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto seconds = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    try {
        step_to_the_end();
    } catch (const std::exception& error) {
        end({std::string("failed: ") + error.what(), seconds()});
        throw;
    }
    const double last = static_cast<double>(step_count(definition)) * definition.solver.step;
    RunEnd how{stepped.time() == last || stepped.arrived() ? "complete" : "interrupted", seconds()};
    end(how);
    return how;
}

void Runner::step_to_the_end() {
    const double step_size = definition.solver.step;
    const auto done = static_cast<std::int64_t>(std::floor(stepped.time() / step_size + rounding));
    record();
    for (std::int64_t i = done + 1; i <= step_count(definition) && !is_over(); ++i) {
        while (stepped.time() < static_cast<double>(i) * step_size && !is_over()) step();
        if (has_frame(definition, i) || is_over()) record();
    }
}

bool Runner::is_over() const {
    return stepped.arrived() ||
           std::ranges::any_of(observers, [](const RunObserver& observer) { return observer.wants_end(); });
}

void Runner::record() {
    for (RunObserver& observer : observers) observer.frame_due(stepped);
}

void Runner::end(const RunEnd& how) {
    for (RunObserver& observer : observers) observer.ended(how);
}

}  // namespace sherd
