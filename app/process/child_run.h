// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>

#include <string>
#include <vector>

#include "app/files/disk/disk_file.h"
#include "app/progress/progress_meter.h"

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

/// A run in a child process.
class ChildRun {
  public:
    /// total: its progress at the end, such as the scene's duration. Throws Error (run) if it cannot be
    /// started.
    ChildRun(std::string name, double total, std::vector<std::string> arguments,
             const std::string& program = ChildProcess::this_program);

    /// Adds the pipes that are still open.
    void add_pipes(std::vector<pollfd>& pipes) const;
    /// Reads the output that is in the pipes, and the progress into the meter. Returns false when all have
    /// ended.
    bool listen();
    /// Returns its output on stderr since the last call, in whole lines, each with its name in front if it
    /// has one; at its end all of the rest.
    std::string take_words();
    /// Waits for the end of the process; returns its exit code.
    int finish();
    void interrupt() { process.interrupt(); }
    /// Processor time, s; after finish().
    double processor_seconds() const { return process.processor_seconds; }

    std::string name;
    ProgressMeter meter;
    std::string results;  ///< stdout

  private:
    bool is_open() const { return out_open || err_open || reports_open; }
    void read_reports();

    ChildProcess process;
    std::string words, reports;
    bool out_open = true, err_open = true, reports_open = true;
};

/// Exit code and output of a program.
struct ProgramEnd {
    int exit_code = 0;
    std::string out, err;
};

/// Runs a program to its end. Throws Error (run) when it cannot be started.
ProgramEnd end_of(const std::string& program, const std::vector<std::string>& arguments);

/// Returns the error in the output of a program of this project, or the last line of another program.
std::string reason_in(const std::string& words);

}  // namespace sherd
