// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/process/child_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "app/files/program_file.h"
#include "app/machine/exit_code.h"
#include "app/messages/split.h"
#include "app/progress/run_progress.h"
#include "meshops/error.h"

namespace sherd {
namespace {

void require(int reason) {
    if (reason != 0)
        throw Error(fmt::format("cannot start another process: {}", std::strerror(reason)), Fault::run);
}

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Creates a pipe, moves its read end into `to_read`, and returns its write end.
Descriptor open_pipe(Descriptor& to_read) {
    std::array<int, 2> ends{-1, -1};
    require(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno);
    to_read = Descriptor(ends[0]);
    return Descriptor(ends[1]);
}

/// Appends to `text` output that waits in a pipe; does not wait for more. Returns false at the end of the
/// pipe.
bool read_some(int pipe, std::string& text) {
    pollfd waiting{pipe, POLLIN, 0};
    if (poll(&waiting, 1, 0) <= 0) return true;
    std::array<char, 4096> buffer;
    const ssize_t count = read(pipe, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

/// Removes the complete lines from the beginning of a text, and returns them.
std::vector<std::string> take_lines(std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
        lines.push_back(text.substr(0, end));
        text.erase(0, end + 1);
    }
    return lines;
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> arguments, const std::string& program) {
    const std::string file = program == this_program ? program_to_start().string() : program;
    std::string name = program;
    std::vector<char*> pointers{name.data()};
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const Descriptor outputs = open_pipe(out), errors = open_pipe(err), told = open_pipe(reports);
    posix_spawn_file_actions_t redirection;
    posix_spawn_file_actions_init(&redirection);
    posix_spawn_file_actions_adddup2(&redirection, outputs, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&redirection, errors, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&redirection, told, report_descriptor);
    const int reason = posix_spawnp(&process, file.c_str(), &redirection, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&redirection);
    require(reason);
}

ChildProcess::~ChildProcess() {
    interrupt();
    wait();  // the pipes stay open for the child's last output
}

void ChildProcess::interrupt() const {
    if (process != 0) kill(process, SIGTERM);
}

int ChildProcess::wait() {
    if (process == 0) return 0;
    int status = 0;
    rusage usage{};
    while (wait4(process, &status, 0, &usage) < 0 && errno == EINTR) continue;
    process = 0;
    processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    return exit_code_of(status);
}

ChildRun::ChildRun(std::string name_, double total, std::vector<std::string> arguments,
                   const std::string& program)
    : name(std::move(name_)), meter(total, name), process(std::move(arguments), program) {
    meter.update(0, {{{"starting", 1}}, {}});
}

void ChildRun::add_pipes(std::vector<pollfd>& pipes) const {
    if (out_open) pipes.push_back({process.out, POLLIN, 0});
    if (err_open) pipes.push_back({process.err, POLLIN, 0});
    if (reports_open) pipes.push_back({process.reports, POLLIN, 0});
}

bool ChildRun::listen() {
    if (out_open) out_open = read_some(process.out, results);
    if (err_open) err_open = read_some(process.err, words);
    if (reports_open) reports_open = read_some(process.reports, reports);
    read_reports();
    return is_open();
}

void ChildRun::read_reports() {
    for (const std::string& line : take_lines(reports))
        if (const auto progress = run_progress(line)) meter.update(progress->time, progress_text(*progress));
}

std::string ChildRun::take_words() {
    if (!is_open() && !words.empty() && !words.ends_with('\n')) words += '\n';
    std::string text;
    for (const std::string& line : take_lines(words))
        text += name.empty() ? line + "\n" : fmt::format("{}: {}\n", name, line);
    return text;
}

int ChildRun::finish() {
    const int exit_code = process.wait();
    meter.end(exit_code == 0 ? "took" : "ended after");
    return exit_code;
}

ProgramEnd end_of(const std::string& program, const std::vector<std::string>& arguments) {
    ChildRun run("", 1, arguments, program);
    while (run.listen()) {
        std::vector<pollfd> pipes;
        run.add_pipes(pipes);
        poll(pipes.data(), pipes.size(), -1);
    }
    ProgramEnd end;
    end.err = run.take_words();
    end.out = run.results;
    end.exit_code = run.finish();
    return end;
}

std::string reason_in(const std::string& words) {
    std::string last;
    for (const std::string& line : split(words, '\n')) {
        constexpr std::string_view error = "sherd: error: ";
        if (const std::size_t at = line.find(error); at != std::string::npos)
            return line.substr(at + error.size());
        if (!line.empty()) last = line;
    }
    return last;
}

}  // namespace sherd
