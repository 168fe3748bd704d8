// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/files/descriptor.h"

namespace sherd {

/// This program once more, or another one, running beside the first one with its output in pipes, and one
/// pipe more by which it can tell how far it is.
class ChildProcess {
  public:
    static constexpr const char* this_program = "sherd";

    /// arguments: without the program's name. Throws Error (run) when it cannot be started.
    explicit ChildProcess(std::vector<std::string> arguments, const std::string& program = this_program);
    /// Interrupts it, if it is still running, and waits for its end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends it SIGTERM.
    void interrupt() const;
    /// Waits for its end. Returns its exit code; 128 + signal when one ended it.
    int wait();

    static constexpr int report_descriptor = 3;  ///< where it writes what `reports` reads

    Descriptor out, err, reports;  ///< to read from: its stdout, its stderr, its reports
    double processor_seconds = 0;  ///< that it took, after wait()

  private:
    int process = 0;  ///< 0: it has ended
};

}  // namespace sherd
