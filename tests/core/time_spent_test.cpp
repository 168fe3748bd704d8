// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time_spent.h"

#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

constexpr Task tasks[] = {Task::other,    Task::elasticity,    Task::contact,  Task::loads,
                          Task::analysis, Task::factorization, Task::solution, Task::breaking};
constexpr double nap = 2e-3;  // s
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void wait_for(double seconds) {
    for (const Clock::time_point start = Clock::now(); seconds_since(start) < seconds;) {
    }
}

double sum(const TimeSpent& spent) {
    double sum = 0;
    for (const Task task : tasks) {
        EXPECT_GE(spent.on(task), 0);
        sum += spent.on(task);
    }
    return sum;
}

/// Lets two plates fall onto each other for five steps. result: time spent by task; wall: s, elapsed time.
void let_plates_fall(bool sheet_contact, TimeSpent& result, double& wall) {
    Shell shell = test::stacked_plates(2, 4, 1.2 * test::ceramic.thickness, test::ceramic);
    shell.velocity.rightCols(shell.velocity.cols() / 2).row(2).setConstant(-2);
    StepperOptions options;
    options.tolerance = 1e-8;
    options.contact.sheets = sheet_contact;
    const Clock::time_point start = Clock::now();
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < 5; ++i) {
        time_step.begin();
        EXPECT_TRUE(time_step.solve(200));
        time_step.finish();
    }
    wall = seconds_since(start);
    result = time_step.time_spent();
}

// The search for pairs happens inside other tasks: its time must be counted once, and not for these tasks.
TEST(TimeSpent, EachMomentCountsForTheInnermostTask) {
    const Clock::time_point start = Clock::now();
    TimeSpent spent;
    {
        const Stopwatch outer(spent, Task::contact);
        wait_for(nap);
        {
            const Stopwatch inner(spent, Task::analysis);
            wait_for(nap);
        }
        wait_for(nap);
    }
    wait_for(nap);
    const double wall = seconds_since(start);
    EXPECT_GE(spent.on(Task::contact), 2 * nap);
    EXPECT_GE(spent.on(Task::analysis), nap);
    EXPECT_LE(sum(spent), wall - nap) << "what came after the stopwatch counts for its task";
    EXPECT_EQ(spent.times(Task::contact), 1) << "returning to a task begins no other one";
    EXPECT_EQ(spent.times(Task::analysis), 1);
    EXPECT_EQ(spent.times(Task::factorization), 0);
}

// With wrong parts, the table at the end of a run would show too much time, or leave out the largest cost.
TEST(TimeSpent, PartsOfAStepAreNoMoreThanTheWhole) {
    TimeSpent spent;
    double wall = 0;
    let_plates_fall(true, spent, wall);
    EXPECT_LE(sum(spent), wall);
    for (const Task task :
         {Task::elasticity, Task::contact, Task::analysis, Task::factorization, Task::solution})
        EXPECT_GT(spent.on(task), 0) << static_cast<int>(task);
    EXPECT_EQ(spent.on(Task::breaking), 0);
}

// Time of other tasks must not be charged to contact.
TEST(TimeSpent, NothingGoesIntoContactWhereThereIsNone) {
    TimeSpent spent;
    double wall = 0;
    let_plates_fall(false, spent, wall);
    EXPECT_LE(sum(spent), wall);
    EXPECT_EQ(spent.on(Task::contact), 0);
    EXPECT_GT(spent.on(Task::elasticity), 0);
}

}  // namespace
}  // namespace sherd
