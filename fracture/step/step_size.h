// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

namespace sherd {

/// The length of time steps: the nominal one, halved when a step has to be shorter, and doubled again after
/// four successful steps. No step crosses a multiple of the nominal length.
class StepSize {
  public:
    static constexpr int most_halvings = 10;  ///< the smallest step is 1/1024 of the nominal one

    /// nominal: nominal length, s.
    explicit StepSize(double nominal) : nominal(nominal) {}

    double size() const { return seconds(ticks()); }  ///< s, length of the next step
    double time() const { return seconds(done); }     ///< s, end of the last step

    bool can_halve() const { return length > smallest; }
    /// Halves the next step. Returns false when it has the smallest length already.
    bool halve();
    /// Sets the length of all steps until resume() to the nominal length, halved `halvings` times.
    void keep(int halvings);
    void resume();
    /// Nominal length, halved `halvings` times, s.
    double size_of(int halvings) const { return seconds(ticks_of(halvings)); }
    /// Whether the next step begins at a multiple of the nominal length, halved `halvings` times.
    bool is_multiple(int halvings) const { return done % ticks_of(halvings) == 0; }
    /// Whether the next step begins at a multiple of the nominal length.
    bool is_at_whole() const { return is_multiple(0); }
    /// Must be called when the next step is finished.
    void advance();

  private:
    // Number of successful steps in succession before a longer step is tried.
    static constexpr int required_successes = 4;
    // Lengths are multiples of a tick, so that times have no round-off that adds up.
    static constexpr std::int64_t smallest = 1024, whole = smallest << most_halvings;

    static std::int64_t ticks_of(int halvings) { return whole >> std::min(halvings, most_halvings); }
    /// Length of the next step, ticks: all that is left up to the next multiple of the nominal length, if
    /// this is at most `length`; half of it, if it is less than two lengths; else `length`.
    std::int64_t ticks() const {
        const std::int64_t left = whole - done % whole;
        return left <= length ? left : left < 2 * length ? (left + 1) / 2 : length;
    }
    /// Time of `count` ticks, s: exactly an integer times the nominal length after whole steps.
    double seconds(std::int64_t count) const {
        return static_cast<double>(count) * nominal / static_cast<double>(whole);
    }

    double nominal;
    std::int64_t done = 0;        ///< ticks, end of the last step
    std::int64_t length = whole;  ///< ticks, length of the next step if enough is left
    int successes = 0;            ///< successful steps since the last change of length
    bool is_kept = false;         ///< whether the length stays until resume()
};

}  // namespace sherd
