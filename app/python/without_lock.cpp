// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/without_lock.h"

#include <pthread.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <condition_variable>
#include <mutex>

namespace sherd::python {
namespace {

/// State of the threads that have released Python's lock. A process has a single Python, and thus a single
/// object of this struct.
struct Outside {
    std::mutex mutex;
    std::condition_variable changed;
    int threads = 0;
    bool python_has_ended = false;
};

Outside*& current() {
    static Outside* only = new Outside;  // never destroyed: sleeping threads outlive all static objects
    return only;
}

/// Resets the state in a forked process, which has only the thread that called fork.
void begin_anew() {
    current() = new Outside;
}

Outside& outside() {
    static const int registered = pthread_atfork(nullptr, nullptr, begin_anew);
    static_cast<void>(registered);
    return *current();
}

/// Sleeps until the process ends.
[[noreturn]] void sleep_on() {
    for (;;) pause();
}

}  // namespace

WithoutLock::WithoutLock() : state(PyEval_SaveThread()) {
    std::unique_lock lock(outside().mutex);
    if (!outside().python_has_ended) {
        ++outside().threads;
        return;
    }
    lock.unlock();
    sleep_on();
}

WithoutLock::~WithoutLock() {
    {
        std::unique_lock lock(outside().mutex);
        if (outside().python_has_ended) {
            --outside().threads;
            outside().changed.notify_all();
            lock.unlock();
            sleep_on();
        }
    }
    PyEval_RestoreThread(static_cast<PyThreadState*>(state));
    const std::lock_guard lock(outside().mutex);
    --outside().threads;
    outside().changed.notify_all();
}

void end_of_python() {
    PyThreadState* const state = PyEval_SaveThread();
    {
        std::unique_lock lock(outside().mutex);
        outside().python_has_ended = true;
        outside().changed.wait(lock, [] { return outside().threads == 0; });
    }
    PyEval_RestoreThread(state);
}

}  // namespace sherd::python
