// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd::python {

/// Releases Python's lock for other threads during its lifetime. When Python ends, end_of_python() waits for
/// all such objects, and their threads sleep from then on: a daemon thread that requested the lock after that
/// would be ended by Python in the middle of C++, which ends the program (SIGABRT).
class WithoutLock {
  public:
    WithoutLock();
    ~WithoutLock();
    WithoutLock(const WithoutLock&) = delete;

  private:
    void* state;  ///< PyThreadState
};

/// To be called by `atexit`, with the lock: from then on no thread returns to Python.
void end_of_python();

}  // namespace sherd::python
