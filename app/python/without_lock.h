// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd::python {

/// Releases Python's lock for other threads during its lifetime. When Python ends, end_of_python() waits
/// until the destructors of all such objects have been called; their threads then sleep and never take the
/// lock again. Without this, Python would end a daemon thread that requests the lock in the middle of C++,
/// which ends the program (SIGABRT).
class WithoutLock {
  public:
    WithoutLock();
    ~WithoutLock();
    WithoutLock(const WithoutLock&) = delete;

  private:
    void* state;  ///< PyThreadState
};

/// To be called by `atexit`, with Python's lock: from then on no thread returns to Python.
void end_of_python();

}  // namespace sherd::python
