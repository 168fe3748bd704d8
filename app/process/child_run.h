// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <poll.h>

#include <string>
#include <vector>

#include "app/process/child_process.h"
#include "app/progress/progress_meter.h"

namespace sherd {

/// A run in a process of its own.
class ChildRun {
  public:
    /// total: what its progress counts to, as the scene's duration. Throws Error (run) when it cannot be
    /// started.
    ChildRun(std::string name, double total, std::vector<std::string> arguments,
             const std::string& program = ChildProcess::this_program);

    /// Its pipes that may have something to say.
    void add_pipes(std::vector<pollfd>& pipes) const;
    /// Reads what there is in its pipes, its progress into the meter. Returns false when there will be no
    /// more.
    bool listen();
    /// What it has said on stderr since this was asked last, in whole lines with its name, if it has one, in
    /// front; at its end all.
    std::string take_words();
    /// Waits for its end; returns its exit code.
    int finish();
    void interrupt() { process.interrupt(); }
    /// Of the processor, s; after finish().
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

/// How a program has ended, and all that it said.
struct ProgramEnd {
    int exit_code = 0;
    std::string out, err;
};

/// Runs a program to its end. Throws Error (run) when it cannot be started.
ProgramEnd end_of(const std::string& program, const std::vector<std::string>& arguments);

/// The error that a program of ours tells in its words, or the last line of another one.
std::string reason_in(const std::string& words);

}  // namespace sherd
