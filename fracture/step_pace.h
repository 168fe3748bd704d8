// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/state_visitor.h"

namespace sherd {

/// Why an implicit step is made of explicit ones, or an explicit one of implicit ones.
enum class Urgency : std::uint8_t {
    none,
    strike,       ///< something strikes, and the time scheme takes much of its energy
    stress,       ///< something may fail soon
    crack,        ///< something fails
    unsolved,     ///< the step cannot be solved
    overwhelmed,  ///< explicit steps cannot go on: implicit ones shall
    passage,      ///< something passes through what it meets in the step that was solved
};

inline constexpr std::size_t urgency_count = 7;

/// What a step has done, or would do.
struct StepActivity {
    double overload = 0;   ///< see StepReport::peak_overload
    bool fails = false;    ///< whether anything does
    double contact = 0;    ///< J, stored in contact at its end
    double by_scheme = 0;  ///< J, that the time scheme takes
    double energy = 0;     ///< J, kinetic and stored, at its end
};

/// Judges steps by what they do. Where schemes alternate, explicit steps follow when an implicit one has been
/// solved and turns out urgent, and implicit ones when nothing has happened for some whole steps: twice as
/// many of them each time that explicit steps had to follow at once again. When explicit steps cannot go on,
/// implicit ones follow for some whole steps, urgent or not: twice as many each time.
class StepPace {
  public:
    /// little: J, so much and less in a step is never a blow.
    explicit StepPace(double little = 0) : little(little) {}
    /// Of an implicit step that has been solved.
    Urgency judge(const StepActivity& solved) const;
    /// An implicit step has been finished; whole: at a multiple of the nominal length.
    void implicit_finished(const StepActivity& step, bool whole);
    /// Explicit steps follow.
    void goes_explicit();
    /// Implicit steps follow, because explicit ones cannot go on.
    void stays_implicit();
    bool is_held() const { return held > 0; }  ///< whether steps must be implicit
    /// An explicit step has been finished; whole: as before. Returns whether implicit steps shall follow.
    bool explicit_finished(const StepActivity& step, bool whole);
    void visit_state(StateVisitor& visit) {
        auto& [little, largest_energy, is_busy, contact, quiet, enough, implicit_steps, held, hold] = *this;
        visit(largest_energy, is_busy, contact, quiet, enough, implicit_steps, held, hold);
    }

  private:
    static constexpr int least_quiet = 4;  // whole steps
    static constexpr int calming = 3;      // implicit steps that take what still rings

    /// Of energies, J. What lies on something, or is pressed, keeps its contact; a blow makes and ends one.
    struct Range {
        double least = std::numeric_limits<double>::infinity(), most = -least;
        void add(double energy);
        double width() const { return most - least; }
        void visit_state(StateVisitor& visit) { visit(least, most); }
    };

    double much(const StepActivity& step) const;  ///< J
    bool strikes(const StepActivity& solved) const;

    double little;                 ///< J
    double largest_energy = 0;     ///< J, StepActivity::energy in all steps
    bool is_busy = false;          ///< whether anything has failed since the last whole step
    Range contact;                 ///< stored in contact, from the end of the last whole step on
    int quiet = 0;                 ///< whole steps in which nothing has
    int enough = least_quiet;      ///< of them, for implicit steps to follow
    int implicit_steps = calming;  ///< since the last explicit one
    int held = 0;                  ///< whole steps that still must be implicit
    int hold = least_quiet;        ///< of them, the next time that explicit ones cannot go on
};

}  // namespace sherd
