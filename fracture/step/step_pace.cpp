// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/step_pace.h"

namespace sherd {
namespace {

// Energy that makes a contact an impact in a step, over the largest energy so far.
constexpr double impact_share = 5e-3;
// Overload of an edge near failure; implicit steps underestimate overloads.
constexpr double near_failure = 0.7;
// few_implicit_steps: if explicit steps begin again after fewer implicit steps, the implicit steps had begun
// too early. most_quiet_steps: limit on the numbers of quiet and of forced whole steps.
constexpr int few_implicit_steps = 8, most_quiet_steps = 64;

}  // namespace

void StepPace::Range::add(double energy) {
    least = std::min(least, energy);
    most = std::max(most, energy);
}

double StepPace::impact_energy(const StepActivity& step) const {
    return std::max(energy_floor, impact_share * std::max(largest_energy, step.energy));
}

bool StepPace::is_impact(const StepActivity& solved) const {
    return solved.contact > 0 && solved.by_scheme > impact_energy(solved);
}

Urgency StepPace::urgency_of(const StepActivity& solved) const {
    if (must_be_implicit()) return Urgency::none;
    if (solved.fails) return Urgency::crack;
    if (implicit_steps < damping_steps) return Urgency::none;
    if (solved.overload > near_failure) return Urgency::stress;
    return is_impact(solved) ? Urgency::strike : Urgency::none;
}

void StepPace::implicit_finished(const StepActivity& step, bool whole) {
    largest_energy = std::max(largest_energy, step.energy);
    ++implicit_steps;
    if (whole && must_be_implicit()) --forced_implicit_steps;
}

void StepPace::begin_explicit() {
    const bool returned_too_early = implicit_steps < few_implicit_steps && quiet_steps > 0;
    required_quiet_steps =
        returned_too_early ? std::min(2 * required_quiet_steps, most_quiet_steps) : least_quiet_steps;
    quiet_steps = implicit_steps = forced_implicit_steps = 0;
    has_failed = false;
    contact = {};
}

void StepPace::begin_forced_implicit() {
    forced_implicit_steps = next_forced_steps;
    next_forced_steps = std::min(2 * next_forced_steps, most_quiet_steps);
    quiet_steps = implicit_steps = 0;
}

bool StepPace::explicit_finished(const StepActivity& step, bool whole) {
    largest_energy = std::max(largest_energy, step.energy);
    // Vibrations that break no edge are ignored: they only decay.
    has_failed = has_failed || step.fails;
    contact.add(step.contact);
    if (!whole) return false;
    quiet_steps = has_failed || contact.width() > impact_energy(step) ? 0 : quiet_steps + 1;
    has_failed = false;
    contact = {step.contact, step.contact};
    return quiet_steps >= required_quiet_steps;
}

}  // namespace sherd
