// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "meshops/error.h"

namespace sherd {
namespace {

constexpr const char* this_program = "/proc/self/exe";  // also where PATH or the working directory changed

void require(int reason) {
    if (reason != 0)
        throw Error(fmt::format("cannot start another process: {}", std::strerror(reason)), Fault::run);
}

/// Ends for reading and for writing.
std::array<int, 2> open_pipe() {
    std::array<int, 2> ends{-1, -1};
    require(pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno);
    return ends;
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> arguments) {
    std::string name = "sherd";
    std::vector<char*> pointers{name.data()};
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const std::array<int, 2> outputs = open_pipe(), errors = open_pipe();
    out = outputs[0];
    err = errors[0];
    posix_spawn_file_actions_t redirection;
    posix_spawn_file_actions_init(&redirection);
    posix_spawn_file_actions_adddup2(&redirection, outputs[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&redirection, errors[1], STDERR_FILENO);
    const int reason = posix_spawn(&process, this_program, &redirection, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&redirection);
    close(outputs[1]);
    close(errors[1]);
    require(reason);
}

ChildProcess::~ChildProcess() {
    interrupt();
    wait();  // with the pipes open: its last words must not end it
    close(out);
    close(err);
}

void ChildProcess::interrupt() const {
    if (process != 0) kill(process, SIGINT);
}

int ChildProcess::wait() {
    if (process == 0) return 0;
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
    process = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace sherd
