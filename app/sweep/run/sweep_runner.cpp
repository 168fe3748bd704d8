// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/sweep_runner.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include "app/machine/exit_code.h"
#include "app/machine/threads.h"
#include "app/progress/interruption.h"

namespace sherd {
namespace {

constexpr int patience = 50;          // ms, longest time until an interruption is noticed
constexpr double most_of_row = 0.99;  // share of the run in a row's progress; measuring is the rest

/// Whether an interruption has ended a row. When Slurm cancels a job, it sends SIGTERM to all processes of
/// the job, so that a row may end before this process receives the signal. If SIGTERM has ended the row, the
/// function waits for the signal.
bool is_cut_short(const RowResult& row) {
    constexpr int terminated = signal_base + SIGTERM;
    constexpr auto pause = std::chrono::milliseconds(10), longest = std::chrono::milliseconds(5000);
    if (row.exit_code == 0) return false;
    for (auto waited = pause; row.exit_code == terminated && !interrupted() && waited <= longest;
         waited += pause)
        std::this_thread::sleep_for(pause);
    return interrupted();
}

}  // namespace

SweepRunner::SweepRunner(const Study& study, const StudyRows& rows, std::filesystem::path folder,
                         std::vector<std::size_t> wanted_, int jobs)
    : study(study),
      rows(rows),
      folder(std::move(folder)),
      wanted(std::move(wanted_)),
      jobs(jobs),
      threads(threads_of_run(0, jobs)),
      meter(static_cast<double>(wanted.size())) {}

void SweepRunner::start_some() {
    while (next < wanted.size() && running.size() < static_cast<std::size_t>(jobs))
        running.emplace_back(study, rows, rows.rows[wanted[next++]], folder, threads);
}

void SweepRunner::wait_for_output() const {
    std::vector<pollfd> pipes;
    for (const RowRun& run : running) run.add_pipes(pipes);
    poll(pipes.data(), pipes.size(), patience);
}

void SweepRunner::listen(ResultJournal& journal) {
    for (auto run = running.begin(); run != running.end();) {
        if (run->listen()) {
            ++run;
            continue;
        }
        const RowResult result = run->finish();
        run = running.erase(run);
        if (is_cut_short(result)) continue;
        journal.append(result);
        ++(result.exit_code == 0 ? done : failed);
    }
}

void SweepRunner::show() {
    double amount = static_cast<double>(done + failed);
    for (const RowRun& run : running) amount += most_of_row * run.done();
    ProgressText text{{{fmt::format("{} of {} rows", done + failed, wanted.size()), 0}}, {}};
    if (failed > 0) text.after.push_back({fmt::format("{} failed", failed), 1});
    meter.update(amount, std::move(text));
    ProgressMeter* const all = &meter;
    display.show(std::span(&all, 1));
}

void SweepRunner::stop() {
    stopped = true;
    next = wanted.size();
    for (RowRun& run : running) run.interrupt();
}

void SweepRunner::run(ResultJournal& journal) {
    while (next < wanted.size() || !running.empty()) {
        start_some();
        wait_for_output();
        listen(journal);
        show();
        if (interrupted() && !stopped) stop();
    }
    meter.end(stopped ? "ended after" : "took");
    display.leave(meter);
}

}  // namespace sherd
