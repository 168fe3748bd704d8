// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>

#include <string>
#include <vector>

#include "app/files/disk/disk_file.h"
#include "app/progress/progress_meter.h"

namespace sherd {

/// A child process that runs this program or another one. Pipes connect it to this process: for its stdout,
/// its stderr and the reports of its progress.
class ChildProcess {
  public:
    static constexpr const char* this_program = "sherd";

    /// Starts `program`. arguments: the words of the command line after the program's name. Throws Error
    /// (run) if the program cannot be started.
    explicit ChildProcess(std::vector<std::string> arguments, const std::string& program = this_program);
    /// Interrupts the process if it is still running, and waits for its end.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Sends SIGTERM.
    void interrupt() const;
    /// Waits for the end of the process. Returns its exit code; 128 + signal if a signal ended it.
    int wait();

    static constexpr int report_descriptor = 3;  ///< descriptor to which the child writes reports

    Descriptor out, err, reports;  ///< read ends of the pipes for stdout, stderr and reports
    double processor_seconds = 0;  ///< s, processor time of the child; set by wait()

  private:
    int process = 0;  ///< process id; 0: none, or ended
};

/// A run in a child process, with its output and progress.
class ChildRun {
  public:
    /// Starts the run. name: precedes its lines on stderr; may be empty. total: progress at its end, such as
    /// the scene's duration. Throws Error (run) if the process cannot be started.
    ChildRun(std::string name, double total, std::vector<std::string> arguments,
             const std::string& program = ChildProcess::this_program);

    /// Adds those of the run's pipes that are still open to `pipes`, for poll().
    void add_pipes(std::vector<pollfd>& pipes) const;
    /// Reads the output that waits in the pipes, and updates `meter` with the progress in it. Returns false
    /// when all pipes have ended.
    bool listen();
    /// Returns the complete lines that the process has written to stderr since the last call, each with the
    /// run's name in front unless that is empty. When all pipes have ended, includes an incomplete last line.
    std::string take_words();
    /// Waits for the end of the process; returns its exit code.
    int finish();
    void interrupt() { process.interrupt(); }
    /// Returns the processor time of the process, s; to be called after finish().
    double processor_seconds() const { return process.processor_seconds; }

    std::string name;
    ProgressMeter meter;
    std::string results;  ///< output on stdout so far

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

/// Runs a program to its end, and returns its output. Throws Error (run) if the program cannot be started.
ProgramEnd end_of(const std::string& program, const std::vector<std::string>& arguments);

/// Returns the first error message in `words`, the output of a program of this project. If there is none, as
/// for other programs, returns the last line that is not empty.
std::string reason_in(const std::string& words);

}  // namespace sherd
