// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/step_policy.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

/// Number of halvings by which explicit steps may be longer while no edge will fail soon, and the number of
/// such steps in which none must be expected to fail.
constexpr int fewer_halvings = 4, steps_without_failure = 2;

/// Number of times that a step of `step` s must be halved to be at most `length` s.
int halvings_to(double length, double step) {
    return std::max(0, static_cast<int>(std::ceil(std::log2(step / length))));
}

}  // namespace

StepPolicy::StepPolicy(const SimulationOptions& options, double energy_floor)
    : alternates(options.alternates),
      explicit_halvings(halvings_to(options.explicit_step, options.stepper.step)),
      scheme(options.stepper.scheme),
      step_size(options.stepper.step),
      pace(energy_floor) {}

Urgency StepPolicy::urgency(const StepResult& result) const {
    if (result) return Urgency::none;
    if (result.outcome == Outcome::passage) return Urgency::passage;
    return result.outcome == Outcome::failed && is_explicit() ? Urgency::explicit_failed : Urgency::unsolved;
}

bool StepPolicy::retry(const Attempt& last, StepReport& report) {
    const bool has_failed = last.result.outcome == Outcome::failed;
    if (has_failed && !(alternates && (is_explicit() || pace.must_be_implicit()))) return false;
    if (has_failed && is_explicit()) {
        if (is_fallback_tried) return false;
        switch_to_implicit();
        pace.begin_forced_implicit();
        report.urgency = last.urgency;
        return true;
    }
    const bool must_be_implicit = pace.must_be_implicit();
    if ((!can_switch_to_explicit() || must_be_implicit) && step_size.halve()) {
        ++report.halvings;
        return true;
    }
    if (!can_switch_to_explicit()) return false;
    if (must_be_implicit) is_explicit_fallback = is_fallback_tried = true;
    switch_to_explicit();
    report.urgency = last.urgency;
    return true;
}

void StepPolicy::switch_to_explicit() {
    scheme = Scheme::explicit_differences;
    pace.begin_explicit();
    step_size.keep(explicit_halvings);
}

void StepPolicy::switch_to_implicit() {
    scheme = Scheme::implicit_euler;
    is_explicit_fallback = false;
    step_size.resume();
}

void StepPolicy::finish_step(const StepActivity& step) {
    const bool at_whole = step_size.is_at_whole();
    if (!is_explicit())
        pace.implicit_finished(step, at_whole);
    else if (pace.explicit_finished(step, at_whole) && alternates)
        switch_to_implicit();
    else if (alternates)
        choose_explicit_step(step.time_left);
}

void StepPolicy::choose_explicit_step(double time_left) {
    int halvings = std::max(0, explicit_halvings - fewer_halvings);
    while (halvings < explicit_halvings && (time_left < steps_without_failure * step_size.size_of(halvings) ||
                                            !step_size.is_multiple(halvings)))
        ++halvings;
    step_size.keep(halvings);
}

}  // namespace sherd
