// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd::python {

/// Leaves Python's lock to other threads while it lives. When Python ends, end_of_python() waits for all of
/// these, and the threads that had them sleep from then on: a daemon thread that asked for the lock after
/// that would be ended by Python in the middle of C++, which ends the program (SIGABRT).
class WithoutLock {
  public:
    WithoutLock();
    ~WithoutLock();
    WithoutLock(const WithoutLock&) = delete;

  private:
    void* state;  ///< PyThreadState
};

/// To be called by `atexit`, with the lock: no thread comes back to Python from then on.
void end_of_python();

}  // namespace sherd::python
