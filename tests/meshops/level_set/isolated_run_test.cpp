// SPDX-License-Identifier: GPL-3.0-or-later
// A grid is first read in a process of its own: a damaged file must not end the program, and an intact file
// must not be refused.
#include "meshops/level_set/isolated_run.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <new>
#include <stdexcept>
#include <vector>

#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string crash = "it crashes";

std::string outcome(const std::function<void()>& work, const IsolationLimits& limits = {}) {
    return message_thrown_by([&] { run_isolated(work, limits, crash); });
}

TEST(IsolatedRun, LeavesNothingBehind) {
    int changed = 0;
    EXPECT_EQ(outcome([&] { changed = 1; }), "no error");
    EXPECT_EQ(changed, 0);
    EXPECT_EQ(outcome([] { raise(SIGSEGV); }), crash);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process that nobody has waited for";
    EXPECT_EQ(errno, ECHILD);
}

TEST(IsolatedRun, TellsWhatIsThrown) {
    EXPECT_EQ(outcome([] { throw Error("no grid"); }), "no grid");
    EXPECT_EQ(outcome([] { throw std::runtime_error(""); }), "");
    const std::string much(1'000'000, 'x'), told = outcome([&] { throw std::runtime_error(much); });
    EXPECT_GT(told.size(), 1000u);
    EXPECT_EQ(told, much.substr(0, told.size()));
}

TEST(IsolatedRun, ACrashIsAnError) {
    for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGKILL})
        EXPECT_EQ(outcome([&] { raise(signal); }), crash) << signal;
    EXPECT_EQ(outcome([] { _exit(0); }), crash);
    EXPECT_EQ(outcome([] { throw 1; }), crash) << "no exception that says anything";
}

TEST(IsolatedRun, LimitsAreErrors) {
    const auto takes_memory = [] { std::vector<char>(std::size_t(1) << 28, 'x'); };
    EXPECT_EQ(outcome(takes_memory, {.memory = 1 << 29}), "no error");
    const std::string too_much = outcome(takes_memory, {.memory = 1 << 26});
    EXPECT_TRUE(too_much == std::bad_alloc().what() || too_much == crash)
        << too_much;  // a crash with a sanitizer
    const auto takes_time = [] {
        for (volatile bool on = true; on;) continue;
    };
    EXPECT_EQ(outcome(takes_time, {.seconds = 1}), crash);
}

TEST(IsolatedRun, IsSilent) {
    const TemporaryDirectory directory;
    const std::filesystem::path file = directory.write("said", "");
    const int said = open(file.c_str(), O_WRONLY), error_output = dup(STDERR_FILENO);
    dup2(said, STDERR_FILENO);
    const std::string end = outcome([] {
        std::cerr << "as the C library or a sanitizer, before it ends" << std::endl;
        std::abort();
    });
    dup2(error_output, STDERR_FILENO);
    for (const int descriptor : {said, error_output}) close(descriptor);
    EXPECT_EQ(end, crash);
    EXPECT_EQ(directory.contents().at(file.string()), "");
}

std::size_t parallel_sum(std::size_t count) {
    std::atomic<std::size_t> sum = 0;
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t i) { sum += i; });
    return sum;
}

// A forked process has none of TBB's threads: the process, or its caller afterwards, must not wait for them
// for ever.
TEST(IsolatedRun, MayUseTbbAsMayWhoCallsIt) {
    for (int i = 0; i < 50; ++i) {
        ASSERT_EQ(parallel_sum(10'000), 49'995'000u);
        ASSERT_EQ(outcome([] {
                      if (parallel_sum(10'000) != 49'995'000u) throw Error("a wrong sum");
                  }),
                  "no error");
    }
}

TEST(IsolatedRun, IsLeftOutWhereThreadsOfTbbAreInUse) {
    tbb::task_arena arena(2);
    arena.initialize();
    EXPECT_EQ(outcome([] { raise(SIGSEGV); }), "no error");
    arena.terminate();
    EXPECT_EQ(outcome([] { raise(SIGSEGV); }), crash);
}

}  // namespace
}  // namespace sherd::test
