// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step_pace.h"

namespace sherd {
namespace {

constexpr double much_energy = 5e-3;      // share of the largest energy, in a step
constexpr double near_failure = 0.7;      // overload, which implicit steps underestimate
constexpr int soon = 8, most_quiet = 64;  // implicit steps; whole steps

}  // namespace

void StepPace::Range::add(double energy) {
    least = std::min(least, energy);
    most = std::max(most, energy);
}

double StepPace::much(const StepActivity& step) const {
    return std::max(little, much_energy * std::max(largest_energy, step.energy));
}

bool StepPace::strikes(const StepActivity& solved) const {
    return solved.contact > 0 && solved.by_scheme > much(solved);
}

Urgency StepPace::judge(const StepActivity& solved) const {
    if (is_held()) return Urgency::none;
    if (solved.fails) return Urgency::crack;
    if (implicit_steps < calming) return Urgency::none;
    if (solved.overload > near_failure) return Urgency::stress;
    return strikes(solved) ? Urgency::strike : Urgency::none;
}

void StepPace::implicit_finished(const StepActivity& step, bool whole) {
    largest_energy = std::max(largest_energy, step.energy);
    ++implicit_steps;
    if (whole && is_held()) --held;
}

void StepPace::goes_explicit() {
    const bool in_vain = implicit_steps < soon && quiet > 0;
    enough = in_vain ? std::min(2 * enough, most_quiet) : least_quiet;
    quiet = implicit_steps = held = 0;
    is_busy = false;
    contact = {};
}

void StepPace::stays_implicit() {
    held = hold;
    hold = std::min(2 * hold, most_quiet);
    quiet = implicit_steps = 0;
}

bool StepPace::explicit_finished(const StepActivity& step, bool whole) {
    largest_energy = std::max(largest_energy, step.energy);
    // Vibrations that break nothing are ignored: they only decay.
    is_busy = is_busy || step.fails;
    contact.add(step.contact);
    if (!whole) return false;
    quiet = is_busy || contact.width() > much(step) ? 0 : quiet + 1;
    is_busy = false;
    contact = {step.contact, step.contact};
    return quiet >= enough;
}

}  // namespace sherd
