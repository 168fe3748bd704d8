// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/idle_timer.h"

#include <csignal>
#include <utility>

namespace sherd {
namespace {

/// Blocks all signals in this thread during its lifetime. A thread that is started then inherits the
/// blocking, so that signals are delivered only to this thread, which waits for them.
class BlockedSignals {
  public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before, nullptr); }
    BlockedSignals(const BlockedSignals&) = delete;

  private:
    sigset_t before;
};

}  // namespace

IdleTimer::IdleTimer(std::chrono::milliseconds interval, std::function<void()> call)
    : interval(interval), call(std::move(call)) {
    const BlockedSignals blocked;
    thread = std::thread([this] { wait_and_call(); });
}

IdleTimer::~IdleTimer() {
    {
        const std::lock_guard lock(mutex);
        is_ending = true;
    }
    changed.notify_all();
    thread.join();
}

void IdleTimer::restart() {
    const std::lock_guard lock(mutex);
    begin = std::chrono::steady_clock::now();
}

void IdleTimer::wait_and_call() {
    std::unique_lock lock(mutex);
    while (!is_ending) {
        changed.wait_until(lock, begin + interval);
        if (is_ending || std::chrono::steady_clock::now() < begin + interval) continue;
        begin = std::chrono::steady_clock::now();
        lock.unlock();
        call();
        lock.lock();
    }
}

}  // namespace sherd
