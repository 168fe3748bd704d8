// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <utility>

namespace sherd {

/// What the time of a run goes into.
enum class Task {
    other,
    elasticity,     ///< energies of bending, membrane, clamps and symmetry planes
    contact,        ///< all of contact and friction: energies, finding pairs, continuous detection, and the
                    ///< pattern of Newton's matrix where it is contact that changes it
    loads,          ///< energies of loads, wind and damping
    analysis,       ///< of the pattern of Newton's matrix, by the linear solver
    factorization,  ///< of the matrix
    solution,       ///< with its factor
    breaking        ///< judging hinges, opening the mesh
};

/// How much wall time tasks have taken, each moment counted for one of them. For people to read: no result
/// may depend on it.
class TimeSpent {
  public:
    /// s
    double on(Task task) const { return std::chrono::duration<double>(spent[index(task)]).count(); }

  private:
    friend class Stopwatch;
    using Clock = std::chrono::steady_clock;

    static constexpr std::size_t index(Task task) { return static_cast<std::size_t>(task); }
    /// Ends the current task and begins another one; returns the former.
    Task change(Task task) {
        const Clock::time_point now = Clock::now();
        spent[index(current)] += now - since;
        since = now;
        return std::exchange(current, task);
    }

    std::array<Clock::duration, static_cast<std::size_t>(Task::breaking) + 1> spent{};
    Task current = Task::other;
    Clock::time_point since = Clock::now();
};

/// As long as it lives time is spent on its task, and not on the one that it interrupts.
class Stopwatch {
  public:
    Stopwatch(TimeSpent& time, Task task) : time(time), interrupted(time.change(task)) {}
    ~Stopwatch() { time.change(interrupted); }
    Stopwatch(const Stopwatch&) = delete;

  private:
    TimeSpent& time;
    Task interrupted;
};

}  // namespace sherd
