// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace sherd::test {

/// Output and exit code of a program; after a signal the code is 128 + signal, as in a shell.
struct ProgramResult {
    int exit_code = 0;
    std::string out, err;
};

struct ProgramLimits {
    /// Largest size of a file, bytes: beyond it write() fails, as on a full disk.
    std::optional<std::uint64_t> file_bytes;
    /// Whether flock() fails, as on a file system without locks.
    bool no_locks = false;
};

namespace detail {

using OpenFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

inline OpenFile nameless_file() {
    OpenFile file(std::tmpfile(), &std::fclose);
    if (!file) throw std::runtime_error("cannot make a temporary file");
    return file;
}

inline std::string text_of(std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
    return text;
}

/// Makes the kernel answer flock() of this process with "not implemented".
inline void forbid_locks() {
    sock_filter steps[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_flock, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter{static_cast<unsigned short>(std::size(steps)), steps};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) != 0)
        _exit(126);
}

/// Never returns: becomes the program, or exits with 127.
inline void become(std::vector<char*>& arguments, const std::filesystem::path& directory, std::FILE* out,
                   std::FILE* err, const ProgramLimits& limits) {
    if (limits.file_bytes) {
        const rlimit limit{*limits.file_bytes, *limits.file_bytes};
        std::signal(SIGXFSZ, SIG_IGN);  // makes write() fail with an error instead
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (limits.no_locks) forbid_locks();
    dup2(fileno(out), STDOUT_FILENO);
    dup2(fileno(err), STDERR_FILENO);
    if (chdir(directory.c_str()) == 0) execv(arguments[0], arguments.data());
    _exit(127);
}

}  // namespace detail

/// Runs a program in `directory` and waits for its end. meanwhile: called with the program's process number
/// after its start.
inline ProgramResult run_program(std::string program, std::vector<std::string> arguments,
                                 const std::filesystem::path& directory, const ProgramLimits& limits = {},
                                 const std::function<void(pid_t)>& meanwhile = {}) {
    std::vector<char*> pointers{program.data()};
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const detail::OpenFile out = detail::nameless_file(), err = detail::nameless_file();
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) detail::become(pointers, directory, out.get(), err.get(), limits);
    if (meanwhile) meanwhile(child);
    int status = 0;
    if (waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait for the program");
    const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {exit_code, detail::text_of(out.get()), detail::text_of(err.get())};
}

/// Runs the program sherd by run_program().
inline ProgramResult run_sherd(std::vector<std::string> arguments, const std::filesystem::path& directory,
                               const ProgramLimits& limits = {},
                               const std::function<void(pid_t)>& meanwhile = {}) {
    return run_program(SHERD_PROGRAM, std::move(arguments), directory, limits, meanwhile);
}

}  // namespace sherd::test
