// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/state_visitor.h"

namespace sherd {

/// Reason for another attempt at a step, in which explicit steps may replace an implicit step, or implicit
/// steps an explicit step.
enum class Urgency : std::uint8_t {
    none,
    strike,           ///< an impact, of which the time scheme dissipates much energy
    stress,           ///< an edge is near failure
    crack,            ///< an edge fails
    unsolved,         ///< the step cannot be solved
    explicit_failed,  ///< an explicit step has failed: implicit steps follow
    passage,          ///< surfaces pass through each other in the solved step
};

inline constexpr std::size_t urgency_count = 7;

/// Activity in a step that has been solved or finished.
struct StepActivity {
    double overload = 0;   ///< see StepReport::peak_overload
    bool fails = false;    ///< whether an edge fails
    double contact = 0;    ///< J, stored in contact at the end of the step
    double by_scheme = 0;  ///< J, dissipated by the time scheme
    double energy = 0;     ///< J, kinetic and stored energy at the end of the step
    double time_left = 0;  ///< s, until an edge fails: see Breaker::time_left()
};

/// Decides on the scheme of steps by their activity, if the schemes alternate. A whole step is a step of the
/// nominal length, or the shorter steps that make up this length. Explicit steps replace an implicit step
/// that has been solved and turns out to be urgent. Implicit steps follow again after a number of quiet whole
/// steps, in which no edge fails and no impact occurs. This number doubles each time that explicit steps were
/// needed again soon after implicit steps had begun. After the failure of an explicit step a number of whole
/// steps are implicit, whether urgent or not; this number doubles with each such failure.
class StepPace {
  public:
    /// energy_floor: J, energy up to which a contact is no impact.
    explicit StepPace(double energy_floor = 0) : energy_floor(energy_floor) {}
    /// Returns the urgency of an implicit step that has been solved.
    Urgency urgency_of(const StepActivity& solved) const;
    /// Must be called when an implicit step is finished. whole: whether the step ends at a multiple of the
    /// nominal length.
    void implicit_finished(const StepActivity& step, bool whole);
    /// Must be called before explicit steps.
    void begin_explicit();
    /// Must be called before implicit steps that replace a failed explicit step.
    void begin_forced_implicit();
    bool must_be_implicit() const { return forced_implicit_steps > 0; }  ///< whether steps must be implicit
    /// Must be called when an explicit step is finished. whole: see implicit_finished(). Returns whether
    /// implicit steps shall follow.
    bool explicit_finished(const StepActivity& step, bool whole);
    void visit_state(StateVisitor& visit) {
        auto& [energy_floor, largest_energy, has_failed, contact, quiet_steps, required_quiet_steps,
               implicit_steps, forced_implicit_steps, next_forced_steps] = *this;
        visit(largest_energy, has_failed, contact, quiet_steps, required_quiet_steps, implicit_steps,
              forced_implicit_steps, next_forced_steps);
    }

  private:
    static constexpr int least_quiet_steps = 4;  // least number of quiet whole steps before implicit steps
    static constexpr int damping_steps = 3;      // implicit steps that damp remaining vibrations

    /// Range of contact energies, J. Contact at rest or under constant pressure keeps the range narrow; an
    /// impact widens it.
    struct Range {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        void add(double energy);
        double width() const { return most - least; }
        void visit_state(StateVisitor& visit) { visit(least, most); }
    };

    double impact_energy(const StepActivity& step) const;  ///< J, least energy of an impact
    bool is_impact(const StepActivity& solved) const;

    double energy_floor;        ///< J, energy up to which a contact is no impact
    double largest_energy = 0;  ///< J, largest StepActivity::energy of all steps
    bool has_failed = false;    ///< whether anything has failed since the last whole step
    Range contact;              ///< J, energy stored in contact since the end of the last whole step
    int quiet_steps = 0;        ///< whole steps in succession without failure and impact
    int required_quiet_steps = least_quiet_steps;  ///< quiet steps required before implicit steps
    int implicit_steps = damping_steps;            ///< implicit steps since the last explicit one
    int forced_implicit_steps = 0;                 ///< whole steps that must still be implicit
    /// Number of whole steps that will have to be implicit after the next failure of an explicit step.
    int next_forced_steps = least_quiet_steps;
};

}  // namespace sherd
