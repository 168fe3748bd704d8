// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sherd {

/// The length of time steps: it is the nominal one, is halved when a step cannot be solved, and is doubled
/// again after some successful steps. No step crosses a multiple of the nominal length.
class StepSize {
  public:
    static constexpr int most_halvings = 10;  ///< the smallest step is 1/1024 of the nominal one

    /// nominal: s.
    explicit StepSize(double nominal) : nominal(nominal) {}

    double size() const { return seconds(ticks()); }  ///< s, length of the next step
    double time() const { return seconds(done); }     ///< s, end of the last step

    bool can_halve() const { return halvings < most_halvings; }
    /// Halves the next step. Returns false when it has the smallest length already.
    bool halve();
    /// Must be called when the next step is finished.
    void advance();

  private:
    static constexpr int enough = 4;  // steps in succession that succeed before a longer one is tried

    std::int64_t ticks() const { return std::int64_t{1} << (most_halvings - halvings); }
    /// Exactly an integer times the nominal length after whole steps.
    double seconds(std::int64_t count) const {
        return static_cast<double>(count) * nominal / (1 << most_halvings);
    }

    double nominal;
    std::int64_t done = 0;  ///< in units of the smallest step
    int halvings = 0;       ///< of the next step
    int successes = 0;      ///< steps since the last change of length
};

}  // namespace sherd
