// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <utility>

namespace sherd {

/// The tasks between which the computing time of a run is divided.
enum class Task {
    other,
    elasticity,     ///< energies of bending, membrane, clamps and symmetry planes
    contact,        ///< contact and friction: energies, detection, and changes of Newton's pattern by contact
    loads,          ///< energies of loads, wind and damping
    analysis,       ///< analysis of the pattern of Newton's matrix by the linear solver
    factorization,  ///< factorization of the matrix
    solution,       ///< solution with the factor
    breaking        ///< failure of hinges, and opening of the mesh
};

/// The wall time of each task, with every moment counted for one task only, and the number of times that the
/// task was begun. This is only for information: no result may depend on it.
class TimeSpent {
  public:
    /// Time spent on a task, s.
    double on(Task task) const { return std::chrono::duration<double>(spent[index(task)]).count(); }
    /// Number of stopwatches started on a task. For Task::factorization and Task::analysis it is the number
    /// of factorizations and of analyses.
    std::int64_t times(Task task) const { return begun[index(task)]; }

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

    static constexpr std::size_t tasks = static_cast<std::size_t>(Task::breaking) + 1;
    std::array<Clock::duration, tasks> spent{};
    std::array<std::int64_t, tasks> begun{};
    Task current = Task::other;
    Clock::time_point since = Clock::now();
};

/// While a stopwatch exists, time counts for its task, and not for the task that it interrupts.
class Stopwatch {
  public:
    Stopwatch(TimeSpent& time, Task task) : time(time), interrupted(time.change(task)) {
        ++time.begun[TimeSpent::index(task)];
    }
    ~Stopwatch() { time.change(interrupted); }
    Stopwatch(const Stopwatch&) = delete;

  private:
    TimeSpent& time;
    Task interrupted;
};

}  // namespace sherd
