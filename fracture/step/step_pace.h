// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/state_visitor.h"

namespace sherd {

/// Reason for which explicit steps replace an implicit one, or implicit ones an explicit one.
enum class Urgency : std::uint8_t {
    none,
    strike,           ///< an impact of whose energy the time scheme dissipates much
    stress,           ///< an edge is near failure
    crack,            ///< an edge fails
    unsolved,         ///< the step cannot be solved
    explicit_failed,  ///< explicit steps have failed: implicit ones follow
    passage,          ///< surfaces pass through each other in the solved step
};

inline constexpr std::size_t urgency_count = 7;

/// Activity in a step that has been solved or finished.
struct StepActivity {
    double overload = 0;   ///< see StepReport::peak_overload
    bool fails = false;    ///< whether anything fails
    double contact = 0;    ///< J, stored in contact at its end
    double by_scheme = 0;  ///< J, dissipated by the time scheme
    double energy = 0;     ///< J, kinetic and stored, at its end
};

/// Decides on the scheme of steps by their activity. Where schemes alternate, explicit steps replace an
/// implicit one that has been solved and turns out urgent, and implicit steps follow after some quiet whole
/// steps: after twice as many each time that explicit steps had to follow at once again. After an explicit
/// step that failed some whole steps are implicit, urgent or not: twice as many each time.
class StepPace {
  public:
    /// energy_floor: J, energy up to which a contact is no impact.
    explicit StepPace(double energy_floor = 0) : energy_floor(energy_floor) {}
    /// Returns the urgency of an implicit step that has been solved.
    Urgency urgency_of(const StepActivity& solved) const;
    /// Must be called when an implicit step is finished; whole: whether it ends at a multiple of the nominal
    /// length.
    void implicit_finished(const StepActivity& step, bool whole);
    /// Must be called before explicit steps.
    void begin_explicit();
    /// Must be called before implicit steps that replace failed explicit ones.
    void begin_forced_implicit();
    bool must_be_implicit() const { return forced_implicit_steps > 0; }  ///< whether steps must be implicit
    /// Must be called when an explicit step is finished; whole: see implicit_finished(). Returns whether
    /// implicit steps shall follow.
    bool explicit_finished(const StepActivity& step, bool whole);
    void visit_state(StateVisitor& visit) {
        auto& [energy_floor, largest_energy, has_failed, contact, quiet_steps, required_quiet_steps,
               implicit_steps, forced_implicit_steps, next_forced_steps] = *this;
        visit(largest_energy, has_failed, contact, quiet_steps, required_quiet_steps, implicit_steps,
              forced_implicit_steps, next_forced_steps);
    }

  private:
    static constexpr int least_quiet_steps = 4;  // whole steps
    static constexpr int damping_steps = 3;      // implicit steps that damp remaining vibrations

    /// Range of contact energies, J. Resting or constant pressing keeps it narrow; an impact widens it.
    struct Range {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        void add(double energy);
        double width() const { return most - least; }
        void visit_state(StateVisitor& visit) { visit(least, most); }
    };

    double impact_energy(const StepActivity& step) const;  ///< J
    bool is_impact(const StepActivity& solved) const;

    double energy_floor;        ///< J
    double largest_energy = 0;  ///< J, StepActivity::energy in all steps
    bool has_failed = false;    ///< whether anything has failed since the last whole step
    Range contact;              ///< energy stored in contact, from the end of the last whole step on
    int quiet_steps = 0;        ///< whole steps in succession without failure and impact
    int required_quiet_steps = least_quiet_steps;  ///< quiet steps required before implicit steps
    int implicit_steps = damping_steps;            ///< since the last explicit one
    int forced_implicit_steps = 0;                 ///< whole steps that must still be implicit
    int next_forced_steps =
        least_quiet_steps;  ///< whole steps to hold after the next failure of explicit steps
};

}  // namespace sherd
