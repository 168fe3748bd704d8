// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/files/descriptor.h"

namespace sherd {

/// A child process, of this program or another one, with its output in pipes, and a further pipe for its
/// progress.
class ChildProcess {
  public:
    static constexpr const char* this_program = "sherd";

    /// arguments: without the program's name. Throws Error (run) when it cannot be started.
    explicit ChildProcess(std::vector<std::string> arguments, const std::string& program = this_program);
    /// Interrupts the process if it is still running, and waits for its end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends SIGTERM.
    void interrupt() const;
    /// Waits for the end of the process. Returns its exit code; 128 + signal if one ended it.
    int wait();

    static constexpr int report_descriptor = 3;  ///< where the child writes what `reports` reads

    Descriptor out, err, reports;  ///< read ends of its stdout, its stderr, its reports
    double processor_seconds = 0;  ///< processor time, after wait()

  private:
    int process = 0;  ///< 0: ended
};

}  // namespace sherd
