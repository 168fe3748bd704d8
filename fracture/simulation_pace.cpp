// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "fracture/simulation.h"

// Length and scheme of the steps of a simulation; simulation.cpp has the step.

namespace sherd {
namespace {

/// Number of times that a step must be halved to be at most `length`.
int halvings_to(double length, double step) {
    return std::max(0, static_cast<int>(std::ceil(std::log2(step / length))));
}

}  // namespace

Urgency Simulation::judged(const StepReport& report, const Measured& measured) {
    if (stepper->scheme() == Scheme::explicit_differences || !options.alternates) return Urgency::none;
    const PotentialEnergies stored = stepper->energies();
    StepActivity solved{report.peak_overload, fails(measured), stored.contact, stepper->taken_by_scheme(),
                        kinetic_energy(breakable.mechanics()) + stored.stored()};
    for (const RigidBody& body : bodies()) solved.energy += body.kinetic_energy();
    return pace.judge(solved);
}

bool Simulation::try_otherwise(StepReport& report) {
    if (urgency == Urgency::overwhelmed) {
        if (is_resort_tried) return false;
        report.urgency = urgency;
        is_last_resort = false;
        change_scheme(Scheme::implicit_euler);
        pace.stays_implicit();
        step_size.resume();
        return true;
    }
    const bool can_go_explicit = options.alternates && stepper->scheme() != Scheme::explicit_differences;
    if (can_go_explicit && !pace.is_held()) {
        go_explicit(report);
        return true;
    }
    if (step_size.halve()) {
        ++report.halvings;
        return true;
    }
    if (!can_go_explicit) return false;
    is_last_resort = is_resort_tried = true;
    go_explicit(report);
    return true;
}

void Simulation::go_explicit(StepReport& report) {
    report.urgency = urgency;
    change_scheme(Scheme::explicit_differences);
    pace.goes_explicit();
    step_size.keep(halvings_to(options.explicit_step, options.stepper.step));
}

void Simulation::change_scheme(Scheme scheme) {
    stepper = with_scheme(std::move(stepper), scheme, options.alternates && !is_last_resort);
}

void Simulation::pace_on(const StepReport& report) {
    const StepActivity step{report.peak_overload, report.stages > 0, report.contact, 0,
                            report.kinetic + report.bending + report.membrane + report.contact};
    if (!report.is_explicit) {
        pace.implicit_finished(step, step_size.is_at_whole());
    } else if (pace.explicit_finished(step, step_size.is_at_whole()) && options.alternates) {
        is_last_resort = false;
        change_scheme(Scheme::implicit_euler);
        step_size.resume();
    }
}

}  // namespace sherd
