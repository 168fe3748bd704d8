// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sherd {

/// The length of time steps: the nominal one, halved when a step cannot be solved, doubled again when some
/// have been. Steps never reach over a multiple of the nominal one.
class StepSize {
  public:
    static constexpr int most_halvings = 10;  ///< the smallest step is 1/1024 of the nominal one

    /// nominal: s.
    explicit StepSize(double nominal) : nominal(nominal) {}

    double size() const { return seconds(ticks()); }  ///< s, of the next step
    double time() const { return seconds(done); }     ///< s, at the end of the last one

    /// The next step becomes half as long; false when it is the smallest already.
    bool halve();
    /// The next step is done.
    void advance();

  private:
    static constexpr int enough = 4;  // steps in a row that succeed before a longer one is tried

    std::int64_t ticks() const { return std::int64_t{1} << (most_halvings - halvings); }
    /// Exactly nominal times an integer where whole steps have been done.
    double seconds(std::int64_t count) const {
        return static_cast<double>(count) * nominal / (1 << most_halvings);
    }

    double nominal;
    std::int64_t done = 0;  ///< in smallest steps
    int halvings = 0;       ///< of the next step
    int successes = 0;      ///< since the last change
};

}  // namespace sherd
