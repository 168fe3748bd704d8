// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace sherd {

/// Calls a function, from a thread of its own, each time that an interval has passed without restart().
class IdleTimer {
  public:
    IdleTimer(std::chrono::milliseconds interval, std::function<void()> call);
    /// Ends the thread, after a call in progress.
    ~IdleTimer();
    IdleTimer(const IdleTimer&) = delete;

    /// Starts the interval again.
    void restart();

  private:
    void wait_and_call();

    const std::chrono::milliseconds interval;
    const std::function<void()> call;
    std::mutex mutex;
    std::condition_variable changed;
    std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
    bool is_ending = false;
    std::thread thread;
};

}  // namespace sherd
