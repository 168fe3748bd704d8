// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/level_set/isolated_run.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>

#include "meshops/error.h"

namespace sherd {
namespace {

/// Memory that this process and its copy share, initially zero.
struct Report {
    enum class End { none, passed, failed } end;
    std::array<char, 2048> words;  ///< message of the exception; the last character stays 0
};

struct Unmap {
    void operator()(Report* report) const { munmap(report, sizeof(Report)); }
};

[[noreturn]] void fail(int reason) {
    throw Error("cannot start another process: " + std::generic_category().message(reason), Fault::run);
}

std::unique_ptr<Report, Unmap> shared_report() {
    void* memory = mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) fail(errno);
    return std::unique_ptr<Report, Unmap>(new (memory) Report{});
}

/// Ends TBB's threads, which TBB starts again when needed. A forked process would lack these threads, but
/// might inherit a lock that one of them holds. Returns whether they have ended.
bool end_tbb_threads() {
    tbb::task_scheduler_handle tbb_threads{tbb::attach{}};
    return tbb::finalize(tbb_threads, std::nothrow);
}

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
    rlimit limits{};
    getrlimit(resource, &limits);
    limits.rlim_cur = std::min(limits.rlim_cur, most);
    limits.rlim_max =
        std::min(limits.rlim_max, most);  // the hard limit also ends a process that ignores SIGXCPU
    setrlimit(resource, &limits);
}

void limit_memory(std::uint64_t more) {
    std::uint64_t pages = 0;
    if (std::ifstream("/proc/self/statm") >> pages)
        limit(RLIMIT_AS, pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + more);
}

/// Prepares the copy: suppresses its output, core dumps and signal handlers, and lets it end with its parent,
/// whose file locks it shares. The handling of SIGINT is not changed: from a terminal, this signal reaches
/// both processes.
void be_shadow_of(pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);
    prctl(PR_SET_DUMPABLE, 0);
    for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) std::signal(signal, SIG_DFL);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, output);
}

/// Runs `work`, reports its result and ends the process. Since the function is noexcept, an exception that is
/// no std::exception ends the process, too.
[[noreturn]] void perform(const std::function<void()>& work, const IsolationLimits& limits,
                          Report& report) noexcept {
    limit(RLIMIT_CPU, limits.seconds);
    limit_memory(limits.memory);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    try {
        work();
        report.end = Report::End::passed;
    } catch (const std::exception& error) {
        const std::string_view words = error.what();
        std::copy_n(words.begin(), std::min(words.size(), report.words.size() - 1), report.words.begin());
        report.end = Report::End::failed;
    }
    _exit(0);  // no static destructors, no writing of buffered output: the parent does both
}

}  // namespace

void run_isolated(const std::function<void()>& work, const IsolationLimits& limits,
                  const std::string& crash) {
    if (!end_tbb_threads()) return;
    const auto report = shared_report();
    const pid_t parent = getpid(), child = fork();
    if (child < 0) fail(errno);
    if (child == 0) {
        be_shadow_of(parent);
        perform(work, limits, *report);
    }
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
    if (report->end == Report::End::failed) throw Error(report->words.data());
    if (report->end == Report::End::none) throw Error(crash);
}

}  // namespace sherd
