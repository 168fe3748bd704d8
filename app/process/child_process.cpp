// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/process/child_process.h"

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

#include "app/files/program_file.h"
#include "app/machine/exit_code.h"
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

/// Creates a pipe; keeps its read end, and returns its write end.
Descriptor open_pipe(Descriptor& to_read) {
    std::array<int, 2> ends{-1, -1};
    require(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno);
    to_read = Descriptor(ends[0]);
    return Descriptor(ends[1]);
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
    wait();  // with the pipes open: its last output must not end it
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

}  // namespace sherd
