// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/time/step_result.h"
#include "fracture/step/simulation_options.h"
#include "fracture/step/step_pace.h"
#include "fracture/step/step_report.h"
#include "fracture/step/step_size.h"

namespace sherd {

/// An attempt at a step, which may have ended before the end of the step.
struct Attempt {
    StepResult result = {};           ///< result of the last part of the attempt: beginning or solution
    Urgency urgency = Urgency::none;  ///< reason for another attempt

    explicit operator bool() const { return result && urgency == Urgency::none; }
};

/// The scheme of a stepper; barriers_follow: see ContactOptions.
struct SchemeChoice {
    Scheme scheme;
    bool barriers_follow;

    bool operator==(const SchemeChoice&) const = default;
};

/// Decides on length and scheme of each step, and of the next attempt at a step after a failed attempt. Holds
/// the time of a run.
class StepPolicy {
  public:
    /// energy_floor: see StepPace.
    StepPolicy(const SimulationOptions& options, double energy_floor);

    double size() const { return step_size.size(); }  ///< s, length of the next attempt
    double time() const { return step_size.time(); }  ///< s, end of the last step
    bool can_halve() const { return step_size.can_halve(); }
    bool is_explicit() const { return scheme == Scheme::explicit_differences; }
    SchemeChoice choice() const { return {scheme, alternates && !is_explicit_fallback}; }

    /// Whether finish_step() chooses the length of the next explicit step by StepActivity::time_left.
    bool chooses_explicit_length() const { return alternates && is_explicit(); }

    /// Must be called before the first attempt at a step.
    void begin_step() { is_fallback_tried = false; }
    /// Returns the reason for another attempt after `result`; Urgency::none if its outcome is `done`.
    Urgency urgency(const StepResult& result) const;
    /// Whether explicit steps may replace an implicit one that has been solved: see urgency_of().
    bool can_switch_to_explicit() const { return alternates && !is_explicit(); }
    /// Returns the urgency of an implicit step that has been solved.
    Urgency urgency_of(const StepActivity& solved) const { return pace.urgency_of(solved); }
    /// Prepares another attempt after the failed attempt `last`: with the other scheme, or with half the
    /// length. Enters the change of scheme, or the halving, in the report. Returns false if no other attempt
    /// is left.
    bool retry(const Attempt& last, StepReport& report);
    /// Must be called when a step ends: sets time() to its end.
    void advance() { step_size.advance(); }
    /// Chooses the scheme of the next step, and the length of an explicit one, after advance().
    void finish_step(const StepActivity& step);

    void visit_state(StateVisitor& visit) {
        auto& [alternates, explicit_halvings, scheme, is_explicit_fallback, is_fallback_tried, step_size,
               pace] = *this;
        visit(scheme, is_explicit_fallback, step_size, pace);
    }

  private:
    void switch_to_explicit();
    void switch_to_implicit();
    /// Chooses the length of explicit steps: longer ones while no edge will fail soon.
    void choose_explicit_step(double time_left);

    bool alternates;        ///< SimulationOptions::alternates
    int explicit_halvings;  ///< number of halvings from the nominal length to that of explicit steps
    Scheme scheme;
    /// Whether steps are explicit because implicit steps have failed, too: overlaps may then exceed those
    /// that barriers permit.
    bool is_explicit_fallback = false;
    bool is_fallback_tried = false;  ///< whether this fallback has been tried in the open step
    StepSize step_size;
    StepPace pace;
};

}  // namespace sherd
